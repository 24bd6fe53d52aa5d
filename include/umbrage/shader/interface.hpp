// SPDX-License-Identifier: MIT
//
// Declarations of a shadow in a shader: its uniform block, its map, and a function of world position and normal.
//
// A block consists of mat4 and vec4, whose layout is the same in std140, cbuffers, WGSL and Metal. GLSL 100 to 130 has
// no blocks. There the uniforms are an array of vec4, and glUniform4fv takes the same bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/shader/translate/layout.hpp>

namespace umbrage {

/// Member of a uniform block: one mat4, or one vec4.
struct uniform_field {
    std::string_view name;
    bool matrix = true;

    [[nodiscard]] constexpr std::size_t vectors() const { return matrix ? 4 : 1; }
};

namespace glsl {

/// Binding numbers of an API. Each language uses those it has:
///   OpenGL   bindings of the block and the texture, in GLSL 430 and 310 es or later
///   Vulkan   bindings of the block and the texture, and the set
///   WGSL     bindings of the block, the texture and the sampler, and the group
///   HLSL     registers b, t and s, and the space
///   Metal    none: the function takes arguments instead
struct shader_slots {
    int block = 0, texture = 1, sampler = 2, set = 0;
};

/// Shader function for one shadow. It passes its arguments on, after the map and the block.
struct interface_function {
    struct argument {
        std::string_view name;
        int components = 3;
        bool derived = false;  ///< no parameter: the triangle's normal, of the derivatives of `world`
    };
    std::string_view name{};                     ///< umbrage_<name>_<shadow>; empty: umbrage_<shadow>
    std::string_view calls;                      ///< umbrage_<calls>_<shadow>
    std::string_view says;                       ///< description of its result, for a comment
    int components = 1;                          ///< number of components of its result
    bool reads_map = true, reads_fields = true;  ///< without reads_fields only the last two: shadow_terms
    std::vector<argument> arguments{};
};

/// Declarations of a text for one shadow.
struct shader_interface {
    std::string name;
    std::vector<uniform_field> fields{};  ///< fields of the block
    shader_slots slots{};
    std::vector<interface_function> functions{};

    [[nodiscard]] std::string prefix() const { return "umbrage_" + name; }
};

namespace detail {

/// Parameters that stand for the map, without those that choose one of several: sampler2D map.
struct map_parameter {
    std::string map, sampler;  ///< sampler: empty where there is none
};

/// Call of a function with all its arguments: `umbrage_shadow_sun(map, matrix, vector, world, normal)`.
/// @param normal   the language's expression for a derived argument
template <class Member>
[[nodiscard]] std::string interface_call(const shader_interface& i, const interface_function& f, const std::string& map,
                                         const std::string& sampler, const char* normal, const Member& member) {
    std::string all;
    if (f.reads_map) all += ", " + map + (sampler.empty() ? "" : ", " + sampler);
    for (std::size_t m = f.reads_fields ? 0 : i.fields.size() - 2; m < i.fields.size(); ++m) all += ", " + member(m);
    for (const auto& a : f.arguments) all.append(", ").append(a.derived ? normal : a.name);
    return "umbrage_" + std::string(f.calls) + "_" + i.name + "(" + all.substr(2) + ")";
}

/// Declarations of a function's arguments: "float3 world, float3 normal".
/// @param type   returns the language's word for a number of components
template <class Type>
[[nodiscard]] std::string parameters_of(const interface_function& f, const Type& type, bool type_last = false) {
    std::string all;
    for (const auto& a : f.arguments) {
        if (a.derived) continue;
        const std::string name(a.name);
        all += (all.empty() ? "" : ", ") + (type_last ? name + ": " + type(a.components) : type(a.components) + name);
    }
    return all;
}

/// Declarations of one shadow: their text, the names that it takes besides its functions', and its slots. Two shadows
/// of a text differ in all of them.
struct declaration {
    std::string text;
    std::vector<std::string> names, slots{};
};

[[nodiscard]] inline std::string name_of(const shader_interface& i, const interface_function& f) {
    return f.name.empty() ? i.prefix() : "umbrage_" + std::string(f.name) + "_" + i.name;
}

/// Word for a float vector in HLSL and MSL.
[[nodiscard]] inline std::string float_type(int components) {
    return components == 1 ? "float " : "float" + std::to_string(components) + " ";
}

/// Declaration of a parameter under another name: "sampler2D map" as "sampler2D umbrage_sun_map".
[[nodiscard]] inline std::string renamed(std::string declaration, std::string_view from, const std::string& to) {
    const auto at = declaration.find(declaration.find(std::string(from) + ":") == 0 ? std::string(from) + ":"
                                                                                    : " " + std::string(from));
    return declaration.replace(at + (declaration[at] == ' ' ? 1 : 0), from.size(), to);
}

[[nodiscard]] inline std::string with_head(const std::string& name, const interface_function& f,
                                           const std::string& declaration, const std::string& call) {
    return "\n// " + name + ": " + std::string(f.says) + "\n" +
           laid_out(declaration + " {\n    return " + call + ";\n}\n");
}

[[nodiscard]] inline declaration glsl_interface(const shader_interface& i, const map_parameter& map, version v) {
    const bool vulkan = v == version::vulkan, es = directive(v).ends_with("es") || v == version::v100;
    const bool blocks = v >= version::v150;
    const bool binds = vulkan || v == version::v430 || v == version::v450 || v == version::v460 ||
                       v == version::v310_es || v == version::v320_es;
    const auto slot = [&](int number) {
        return (vulkan ? "set = " + std::to_string(i.slots.set) + ", " : "") + "binding = " + std::to_string(number);
    };
    const std::string block = i.prefix() + "_block", high = es ? "highp " : "";
    std::string out = "\n";
    declaration all{{}, {block, i.prefix() + "_map"}};
    if (binds) {
        const std::string set = " of set " + std::to_string(i.slots.set);
        all.slots = {"binding " + std::to_string(i.slots.block) + (vulkan ? set : " of uniform blocks"),
                     "binding " + std::to_string(i.slots.texture) + (vulkan ? set : " of textures")};
    }
    std::size_t vectors = 0;
    std::vector<std::size_t> first;
    for (const uniform_field& f : i.fields) first.push_back(vectors), vectors += f.vectors();
    if (blocks) {
        out += "layout(std140" + (binds ? ", " + slot(i.slots.block) : "") + ") uniform " + block + " {\n";
        for (const uniform_field& f : i.fields) {
            all.names.push_back(i.prefix() + "_" + std::string(f.name));
            out += "    " + high + (f.matrix ? "mat4 " : "vec4 ") + all.names.back() + ";\n";
        }
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
    const auto type = [&](int components) {
        return high + (components == 1 ? "float " : "vec" + std::to_string(components) + " ");
    };
    for (const interface_function& f : i.functions)
        out += with_head(name_of(i, f), f, type(f.components) + name_of(i, f) + "(" + parameters_of(f, type) + ")",
                         interface_call(i, f, i.prefix() + "_map", "", "cross(dFdx(world), dFdy(world))", member));
    all.text = std::move(out);
    return all;
}

[[nodiscard]] inline declaration hlsl_interface(const shader_interface& i, const map_parameter& map, version) {
    const auto slot = [&](char kind, int number) {
        return " : register(" + (kind + std::to_string(number)) +
               (i.slots.set > 0 ? ", space" + std::to_string(i.slots.set) : "") + ")";
    };
    const auto taken = [&](char kind, int number) {
        return "register " + (kind + std::to_string(number)) + " of space " + std::to_string(i.slots.set);
    };
    declaration all{
        {}, {i.prefix() + "_block", i.prefix() + "_map"}, {taken('b', i.slots.block), taken('t', i.slots.texture)}};
    std::string out = "\ncbuffer " + all.names[0] + slot('b', i.slots.block) + " {\n";
    for (const uniform_field& f : i.fields) {
        all.names.push_back(i.prefix() + "_" + std::string(f.name));
        out += std::string("    ") + (f.matrix ? "column_major float4x4 " : "float4 ") + all.names.back() + ";\n";
    }
    out += "};\n" + renamed(map.map, "map", i.prefix() + "_map") + slot('t', i.slots.texture) + ";\n";
    const std::string sampler = map.sampler.empty() ? "" : i.prefix() + "_sampler";
    if (!sampler.empty()) {
        out += renamed(map.sampler, "map_sampler", sampler) + slot('s', i.slots.sampler) + ";\n";
        all.names.push_back(sampler), all.slots.push_back(taken('s', i.slots.sampler));
    }
    for (const interface_function& f : i.functions)
        out += with_head(
            name_of(i, f), f, float_type(f.components) + name_of(i, f) + "(" + parameters_of(f, float_type) + ")",
            interface_call(i, f, i.prefix() + "_map", sampler, "cross(ddx(world), ddy(world))",
                           [&](std::size_t m) { return i.prefix() + "_" + std::string(i.fields[m].name); }));
    all.text = std::move(out);
    return all;
}

[[nodiscard]] inline declaration wgsl_interface(const shader_interface& i, const map_parameter& map, version) {
    const auto slot = [&](int number) {
        return "@group(" + std::to_string(i.slots.set) + ") @binding(" + std::to_string(number) + ") var";
    };
    const auto taken = [&](int number) {
        return "binding " + std::to_string(number) + " of group " + std::to_string(i.slots.set);
    };
    const std::string block = i.prefix() + "_block", uniforms = i.prefix() + "_uniforms";
    declaration all{{}, {block, uniforms, i.prefix() + "_map"}, {taken(i.slots.block), taken(i.slots.texture)}};
    std::string out = "\nstruct " + block + " {\n";
    for (const uniform_field& f : i.fields)
        out += "    " + std::string(f.name) + (f.matrix ? ": mat4x4f,\n" : ": vec4f,\n");
    out += "}\n" + slot(i.slots.block) + "<uniform> " + uniforms + ": " + block + ";\n" + slot(i.slots.texture) + " " +
           renamed(map.map, "map", i.prefix() + "_map") + ";\n";
    const std::string sampler = map.sampler.empty() ? "" : i.prefix() + "_sampler";
    if (!sampler.empty()) {
        out += slot(i.slots.sampler) + " " + renamed(map.sampler, "map_sampler", sampler) + ";\n";
        all.names.push_back(sampler), all.slots.push_back(taken(i.slots.sampler));
    }
    const auto type = [](int components) {
        return components == 1 ? std::string("f32") : "vec" + std::to_string(components) + "f";
    };
    for (const interface_function& f : i.functions)
        out += with_head(name_of(i, f), f,
                         "fn " + name_of(i, f) + "(" + parameters_of(f, type, true) + ") -> " + type(f.components),
                         interface_call(i, f, i.prefix() + "_map", sampler, "cross(dpdx(world), dpdy(world))",
                                        [&](std::size_t m) { return uniforms + "." + std::string(i.fields[m].name); }));
    all.text = std::move(out);
    return all;
}

[[nodiscard]] inline declaration msl_interface(const shader_interface& i, const map_parameter& map, version) {
    const std::string block = i.prefix() + "_block";
    std::string out = "\nstruct " + block + " {\n";
    for (const uniform_field& f : i.fields)
        out += std::string("    ") + (f.matrix ? "metal::float4x4 " : "float4 ") + std::string(f.name) + ";\n";
    out += "};\n";
    const std::string map_and_sampler = map.map + (map.sampler.empty() ? "" : ", " + map.sampler) + ", ";
    for (const interface_function& f : i.functions)
        out += with_head(name_of(i, f), f,
                         "inline " + float_type(f.components) + name_of(i, f) + "(constant " + block + "& block, " +
                             (f.reads_map ? map_and_sampler : "") + parameters_of(f, float_type) + ")",
                         interface_call(i, f, "map", map.sampler.empty() ? "" : "map_sampler",
                                        "metal::cross(metal::dfdx(world), metal::dfdy(world))",
                                        [&](std::size_t m) { return "block." + std::string(i.fields[m].name); }));
    return {std::move(out), {block}};
}

}  // namespace detail
}  // namespace glsl
}  // namespace umbrage
