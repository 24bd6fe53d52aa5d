// SPDX-License-Identifier: MIT
#include "shader.hpp"

#include <algorithm>
#include <utility>

#include <umbrage/shader/hlsl.hpp>
#include <umbrage/shader/msl.hpp>
#include <umbrage/shader/wgsl.hpp>

namespace parity {

using umbrage::glsl::texture;

namespace {

constexpr std::string_view vec2_in[]{"vec2", "float2", "float2", "vec2f"};
constexpr std::string_view vec3_in[]{"vec3", "float3", "float3", "vec3f"};
constexpr std::string_view vec4_in[]{"vec4", "float4", "float4", "vec4f"};

std::string pair(ivec2 v, dialect::language in) {
    return std::string(vec2_in[in]) + "(" + std::to_string(v.x) + ".0, " + std::to_string(v.y) + ".0)";
}

/// Type that the library declares for a kind of map.
std::string type_of(texture kind, dialect::language in) {
    const auto words = in == dialect::hlsl   ? umbrage::hlsl::detail::texture
                       : in == dialect::msl  ? umbrage::msl::detail::texture
                       : in == dialect::wgsl ? umbrage::wgsl::detail::textures
                                             : umbrage::glsl::detail::glsl_texture;
    const std::string_view parameters = words(kind).parameters, first = parameters.substr(0, parameters.find(','));
    if (in == dialect::wgsl) return std::string(first.substr(first.find(' ') + 1));
    const std::string_view type = first.substr(0, first.rfind(' '));
    return std::string(type.substr(type.find(' ') + 1));
}

}  // namespace

bool bound_map::has_sampler(dialect::language in) const {
    return in != dialect::glsl &&
           (as.gather || compares() || (umbrage::glsl::detail::is_cube(as.texture) && in != dialect::msl));
}

umbrage::glsl::binding bound_map::binding(dialect::language in) const {
    umbrage::glsl::binding b = as;
    if (is_region() && b.texture_size.empty() && in == dialect::hlsl)  // which cannot ask in an expression
        b.texture_size = "(size + " + pair(margin, dialect::glsl) + ")";
    for (std::string* text : {&b.origin, &b.texture_size})
        if (const auto at = text->find("vec2"); at != text->npos) text->replace(at, 4, vec2_in[in]);
    if (in == dialect::wgsl && b.compare.starts_with("float")) b.compare.replace(0, 5, "f32");
    return b;
}

std::string bound_map::arguments(dialect::language in) const {
    const std::string map = name + (has_sampler(in) ? ", " + name + "_sampler" : "");
    std::string chosen = which;
    for (const auto& [word, words] : {std::pair("vec2", vec2_in), std::pair("vec3", vec3_in)})
        if (const auto at = chosen.find(word); at != chosen.npos) chosen.replace(at, 4, words[in]);
    switch (as.texture) {
        case texture::atlas: return map + (as.origin.empty() ? ", " + (which.empty() ? pair(origin, in) : chosen) : "");
        case texture::array:
        case texture::depth_array:
        case texture::shadow_array: return map + ", " + (which.empty() ? "1.0" : chosen);
        case texture::cube: return map + ", 3.0";
        default: return map;
    }
}

std::vector<umbrage::glsl::bound> entry::items() const {
    std::vector<umbrage::glsl::bound> all;
    const std::vector<snippet> unbound = snippets();
    for (const bound_map& b : bound)
        for (const snippet& s : unbound) all.push_back(umbrage::glsl::bind(s, b.name, b.as));
    if (bound.empty())
        for (const snippet& s : unbound) all.push_back(umbrage::glsl::bind(s, "", map_kind));
    return all;
}

bool entry::runs_in(dialect d) const {
    if (d.in != dialect::glsl) return true;
    for (const bound_map& b : bound)  // no depth textures in WebGL 1
        if (b.as.texture == texture::depth && d.of_glsl < version::v130) return false;
    const auto all = items();
    return std::all_of(all.begin(), all.end(), [d](const auto& item) { return supports(item, d.of_glsl); });
}

bool declares(const entry& e, const std::string& map) {
    if (!e.visitor) return false;
    const auto& all = e.visitor->declares;
    return std::find(all.begin(), all.end(), map) != all.end();  // emscripten's library has no std::ranges::find
}

std::array<uniform, max_bindings> uniforms(const entry& e, dialect::language in) {
    std::array<uniform, max_bindings> all;
    const std::string plain = type_of(texture::texture_2d, in);
    for (int i = 0; i < max_inputs; ++i)
        if (e.uses(i)) all[static_cast<std::size_t>(i)] = {plain, "x" + std::to_string(i) + "_texels"};
    if (!e.maps.empty() && e.bound.empty()) all[map_unit(0)] = {plain, "map"};
    for (std::size_t k = 0; k < e.bound.size(); ++k) {
        const bound_map& b = e.bound[k];
        all[map_unit(k)] = {type_of(b.as.texture, in), b.name};
        constexpr std::array samplers{"", "SamplerState", "metal::sampler", "sampler"};
        constexpr std::array comparing{"", "SamplerComparisonState", "metal::sampler", "sampler_comparison"};
        if (b.has_sampler(in))
            all[sampler_binding(map_unit(k))] = {(b.compares() ? comparing : samplers)[in], b.name + "_sampler"};
    }
    if (!e.table.empty()) all[table_unit] = {plain, "table"};
    return all;
}

std::string from_texture(const entry& e, dialect::language in) {
    if (e.bound.empty()) return "";
    if (e.bound.front().as.texture == texture::cube_faces) return " * " + pair({3, 2}, in);
    return e.bound.front().is_region() ? " - " + pair(bound_map::margin, in) : "";
}

std::string map_size(const entry& e) {
    const std::string map = e.bound.empty() ? "map" : e.bound.front().name;
    return "vec2(textureSize(" + map + ", 0))" + from_texture(e, dialect::glsl);
}

call_snippet::call_snippet(const entry& e, dialect::language in) : needs_{e.primitive} {
    if (e.visitor || (in == dialect::glsl && e.bound.empty())) {
        if (!e.visitor) items_ = e.items();
        result_ = e.call;
        return;
    }
    needs_.insert(needs_.end(), e.also.begin(), e.also.end());
    std::vector<std::string> arguments;
    std::string parameters;
    const auto add = [&](const std::string& type, const std::string& name) {
        parameters += (arguments.empty() ? "" : ", ") + type + " " + name;
        arguments.push_back(name);
    };
    for (int i = 0; i < max_inputs; ++i)
        if (e.uses(i)) add("UMBRAGE_HIGHP vec4", "x" + std::to_string(i));
    if (e.call.find("(map,") != e.call.npos) add("UMBRAGE_MAP", "map");
    if (e.call.find("map_size") != e.call.npos) add("UMBRAGE_HIGHP vec2", "map_size");
    if (!e.table.empty()) add("UMBRAGE_MAP", "table");
    const bool several = e.bound.size() > 1;
    source_ = std::string("\nUMBRAGE_HIGHP ") + (several ? "float" : "vec4") + " umbrage_call(" + parameters +
              ") {\n    return " + e.call + ";\n}\n";
    const snippet call{.name = "call", .needs = needs_, .source = source_.c_str()};
    const auto call_of = [&](const std::string& name, const std::string& map) {
        std::string text = name + "(";
        for (const std::string& a : arguments) text += (&a == &arguments.front() ? "" : ", ") + (a == "map" ? map : a);
        return text + ")";
    };
    if (e.bound.empty()) {
        items_.push_back(bind(call, "", e.map_kind));
        result_ = call_of("umbrage_call", "map");
    }
    for (const bound_map& b : e.bound) {
        items_.push_back(umbrage::glsl::bind(call, b.name, b.binding(in)));
        result_ += (result_.empty() ? "" : ", ") + call_of("umbrage_call_" + b.name, b.arguments(in));
    }
    if (several) result_ = std::string(vec4_in[in]) + "(" + result_ + ")";
}

std::string with_mistake(std::string text) {
    if (planted.from.empty()) return text;
    for (auto at = text.find(planted.from); at != text.npos; at = text.find(planted.from, at + planted.to.size()))
        text.replace(at, planted.from.size(), planted.to);
    return text;
}

shader make_shader(const entry& e, dialect d, shader_stage of) {
    if (d == dialect::hlsl) return {"", with_mistake(make_hlsl(e, of))};
    if (d == dialect::wgsl) return {"", with_mistake(make_wgsl(e))};
    const version v = d.of_glsl;
    const bool old = v == version::v100 || v == version::v110 || v == version::v120;
    const bool es = v == version::v100 || v == version::v300_es || v == version::v310_es || v == version::v320_es;
    const bool vulkan = v == version::vulkan, compute = of == shader_stage::compute;
    const bool bits = of == shader_stage::bits && e.output == target::rgba32f;
    const auto located = [&](const char* what) { return (vulkan ? "layout(location = 0) " : "") + std::string(what); };

    const std::string pixel = compute ? "gl_GlobalInvocationID.xy" : "gl_FragCoord.xy";
    shader s;
    if (!compute)
        s.vertex =
            source(v, {}) +
            (old ? "attribute vec2 corner;\nvarying UMBRAGE_HIGHP vec2 position;\n" : located("in vec2 corner;\n")) +
            "void main() {\n" + (old ? "    position = corner * 0.5 + 0.5;\n" : "") +
            "    gl_Position = vec4(corner, 0.0, 1.0);\n}\n";

    // A host shader of low precision: the snippets must ask for what they need.
    const std::string preamble = (es ? "precision mediump float;\nprecision mediump int;\n" : "") + e.preamble;
    std::string& f = s.fragment;
    const call_snippet call(e, dialect::glsl);
    f = source(v, call.items(), preamble) + '\n';
    const auto all = uniforms(e);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].name.empty() || declares(e, all[i].name)) continue;
        if (vulkan) f += "layout(set = 0, binding = " + std::to_string(i) + ") ";
        f += "uniform UMBRAGE_HIGHP " + all[i].type + " " + all[i].name + ";\n";
    }
    if (e.visitor) f += e.visitor->text;
    const bool map = !e.maps.empty();
    if (old && map) f += "uniform UMBRAGE_HIGHP vec2 map_size;\n";
    if (compute)
        f += "layout(local_size_x = " + std::to_string(group_width) +
             ") in;\nlayout(set = 0, binding = " + std::to_string(target_binding) + ", " + format_of(e.output) +
             ") uniform writeonly image2D target;\n";
    else
        f += old ? "varying UMBRAGE_HIGHP vec2 position;\n"
                 : located(bits ? "out UMBRAGE_HIGHP uvec4 result;\n" : "out UMBRAGE_HIGHP vec4 result;\n");
    f += "void main() {\n";
    if (!old && map) f += "    UMBRAGE_HIGHP vec2 map_size = " + map_size(e) + ";\n";
    for (int i = 0; i < max_inputs; ++i) {
        if (!e.uses(i)) continue;
        const std::string x = "x" + std::to_string(i);
        f += "    UMBRAGE_HIGHP vec4 " + x + " = " +
             (old ? "texture2D(" + x + "_texels, position);\n"
                  : "texelFetch(" + x + "_texels, ivec2(" + pixel + "), 0);\n");
    }
    if (compute) {
        f += "    imageStore(target, ivec2(" + pixel + "), " + call.result() + ");\n}\n";
        f = with_mistake(f);
        return s;
    }
    // gl_FragColor is mediump in GLSL ES 1.00. Mesa drops the rounding of a product that is stored as it is, but not of
    // a value that comes out of a branch: that it rounds in the branch.
    const std::string one = v == version::v100 ? " * (position.x < 2.0 ? 1.0 : 0.0)" : "";
    const std::string result = bits ? "floatBitsToUint(" + call.result() + ")" : call.result() + one;
    f += std::string("    ") + (old ? "gl_FragColor" : "result") + " = " + result + ";\n}\n";
    f = with_mistake(f);
    return s;
}

}  // namespace parity
