// SPDX-License-Identifier: MIT
//
// Declarations of a shadow in a shader: its uniform block, its map, and a function of world and normal alone.
//
// A block is mat4s and vec4s, which std140, cbuffers, WGSL and Metal lay out alike. GLSL 100 to 130 has no blocks:
// there it is an array of vec4, and glUniform4fv takes the same bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/shader/translate/layout.hpp>

namespace umbrage {

/// A member of a uniform block: one mat4, or one vec4.
struct uniform_field {
    std::string_view name;
    bool matrix = true;

    [[nodiscard]] constexpr std::size_t vectors() const { return matrix ? 4 : 1; }
};

namespace glsl {

/// The numbers that an API binds by. Languages take those they have: OpenGL from 430 and 310 es on the bindings of
/// block and texture, Vulkan and WGSL the set too, HLSL registers b, t, s and a space; Metal has arguments instead.
struct shader_slots {
    int block = 0, texture = 1, sampler = 2, set = 0;
};

/// What a text declares for one shadow.
struct shader_interface {
    std::string name;                     ///< function umbrage_<name>
    std::vector<uniform_field> fields{};  ///< of the block
    shader_slots slots{};
    bool takes_pixel = false;  ///< a third argument, the position in pixels, for filters that turn

    [[nodiscard]] std::string prefix() const { return "umbrage_" + name; }
};

namespace detail {

/// The parameters that stand for the map, without what chooses one of several: sampler2D map.
struct map_parameter {
    std::string map, sampler;  ///< sampler: empty where there is none
};

/// A call of the shadow's function of all its arguments, `umbrage_shadow_sun(map, matrix, vector, world, normal)`.
template <class Member>
[[nodiscard]] std::string interface_call(const shader_interface& i, const std::string& map, const std::string& sampler,
                                         const Member& member) {
    std::string call = "umbrage_shadow_" + i.name + "(" + map + (sampler.empty() ? "" : ", " + sampler);
    for (std::size_t f = 0; f < i.fields.size(); ++f) call += ", " + member(f);
    return call + ", world, normal" + (i.takes_pixel ? ", pixel)" : ")");
}

/// A declared parameter under another name: "sampler2D map" as "sampler2D umbrage_sun_map".
[[nodiscard]] inline std::string renamed(std::string declaration, std::string_view from, const std::string& to) {
    const auto at = declaration.find(declaration.find(std::string(from) + ":") == 0 ? std::string(from) + ":"
                                                                                    : " " + std::string(from));
    return declaration.replace(at + (declaration[at] == ' ' ? 1 : 0), from.size(), to);
}

[[nodiscard]] inline std::string with_head(const shader_interface& i, const std::string& function) {
    return "\n// " + i.prefix() + ": visibility of a point of the world, 1.0 is lit; a normal of zero is none\n" +
           laid_out(function);
}

[[nodiscard]] inline std::string glsl_interface(const shader_interface& i, const map_parameter& map, version v) {
    const bool vulkan = v == version::vulkan, es = directive(v).ends_with("es") || v == version::v100;
    const bool blocks = v >= version::v150;
    const bool binds = vulkan || v == version::v430 || v == version::v450 || v == version::v460 ||
                       v == version::v310_es || v == version::v320_es;
    const auto slot = [&](int number) {
        return (vulkan ? "set = " + std::to_string(i.slots.set) + ", " : "") + "binding = " + std::to_string(number);
    };
    const std::string block = i.prefix() + "_block", high = es ? "highp " : "";
    std::string out = "\n";
    std::size_t vectors = 0;
    std::vector<std::size_t> first;
    for (const uniform_field& f : i.fields) first.push_back(vectors), vectors += f.vectors();
    if (blocks) {
        out += "layout(std140" + (binds ? ", " + slot(i.slots.block) : "") + ") uniform " + block + " {\n";
        for (const uniform_field& f : i.fields)
            out += "    " + high + (f.matrix ? "mat4 " : "vec4 ") + i.prefix() + "_" + std::string(f.name) + ";\n";
        out += "};\n";
    } else {
        out += "uniform " + high + "vec4 " + block + "[" + std::to_string(vectors) + "];\n";
    }
    out += (binds ? "layout(" + slot(i.slots.texture) + ") " : "") + "uniform " +
           renamed(map.map, "map", i.prefix() + "_map") + ";\n";
    const auto member = [&](std::size_t f) {
        if (blocks) return i.prefix() + "_" + std::string(i.fields[f].name);
        const auto vector = [&](std::size_t n) { return block + "[" + std::to_string(first[f] + n) + "]"; };
        if (!i.fields[f].matrix) return vector(0);
        return "mat4(" + vector(0) + ", " + vector(1) + ", " + vector(2) + ", " + vector(3) + ")";
    };
    return out + with_head(i, high + "float " + i.prefix() + "(" + high + "vec3 world, " + high + "vec3 normal" +
                                  (i.takes_pixel ? ", " + high + "vec2 pixel" : "") + ") {\n    return " +
                                  interface_call(i, i.prefix() + "_map", "", member) + ";\n}\n");
}

[[nodiscard]] inline std::string hlsl_interface(const shader_interface& i, const map_parameter& map, version) {
    const auto slot = [&](char kind, int number) {
        return " : register(" + (kind + std::to_string(number)) +
               (i.slots.set > 0 ? ", space" + std::to_string(i.slots.set) : "") + ")";
    };
    std::string out = "\ncbuffer " + i.prefix() + "_block" + slot('b', i.slots.block) + " {\n";
    for (const uniform_field& f : i.fields)
        out += std::string("    ") + (f.matrix ? "column_major float4x4 " : "float4 ") + i.prefix() + "_" +
               std::string(f.name) + ";\n";
    out += "};\n" + renamed(map.map, "map", i.prefix() + "_map") + slot('t', i.slots.texture) + ";\n";
    const std::string sampler = map.sampler.empty() ? "" : i.prefix() + "_sampler";
    if (!sampler.empty()) out += renamed(map.sampler, "map_sampler", sampler) + slot('s', i.slots.sampler) + ";\n";
    return out + with_head(i, "float " + i.prefix() + "(float3 world, float3 normal" +
                                  (i.takes_pixel ? ", float2 pixel" : "") + ") {\n    return " +
                                  interface_call(
                                      i, i.prefix() + "_map", sampler,
                                      [&](std::size_t f) { return i.prefix() + "_" + std::string(i.fields[f].name); }) +
                                  ";\n}\n");
}

[[nodiscard]] inline std::string wgsl_interface(const shader_interface& i, const map_parameter& map, version) {
    const auto slot = [&](int number) {
        return "@group(" + std::to_string(i.slots.set) + ") @binding(" + std::to_string(number) + ") var";
    };
    const std::string block = i.prefix() + "_block", uniforms = i.prefix() + "_uniforms";
    std::string out = "\nstruct " + block + " {\n";
    for (const uniform_field& f : i.fields)
        out += "    " + std::string(f.name) + (f.matrix ? ": mat4x4f,\n" : ": vec4f,\n");
    out += "}\n" + slot(i.slots.block) + "<uniform> " + uniforms + ": " + block + ";\n" + slot(i.slots.texture) + " " +
           renamed(map.map, "map", i.prefix() + "_map") + ";\n";
    const std::string sampler = map.sampler.empty() ? "" : i.prefix() + "_sampler";
    if (!sampler.empty()) out += slot(i.slots.sampler) + " " + renamed(map.sampler, "map_sampler", sampler) + ";\n";
    return out + with_head(i, "fn " + i.prefix() + "(world: vec3f, normal: vec3f" +
                                  (i.takes_pixel ? ", pixel: vec2f" : "") + ") -> f32 {\n    return " +
                                  interface_call(
                                      i, i.prefix() + "_map", sampler,
                                      [&](std::size_t f) { return uniforms + "." + std::string(i.fields[f].name); }) +
                                  ";\n}\n");
}

[[nodiscard]] inline std::string msl_interface(const shader_interface& i, const map_parameter& map, version) {
    const std::string block = i.prefix() + "_block";
    std::string out = "\nstruct " + block + " {\n";
    for (const uniform_field& f : i.fields)
        out += std::string("    ") + (f.matrix ? "metal::float4x4 " : "float4 ") + std::string(f.name) + ";\n";
    return out + "};\n" +
           with_head(i, "inline float " + i.prefix() + "(constant " + block + "& block, " + map.map +
                            (map.sampler.empty() ? "" : ", " + map.sampler) + ", float3 world, float3 normal" +
                            (i.takes_pixel ? ", float2 pixel" : "") + ") {\n    return " +
                            interface_call(i, "map", map.sampler.empty() ? "" : "map_sampler",
                                           [&](std::size_t f) { return "block." + std::string(i.fields[f].name); }) +
                            ";\n}\n");
}

}  // namespace detail
}  // namespace glsl
}  // namespace umbrage
