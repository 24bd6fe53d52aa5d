// SPDX-License-Identifier: MIT
#include "shader.hpp"

#include <algorithm>

namespace parity {

using umbrage::glsl::texture;

std::string bound_map::arguments() const {
    const std::string region = ", vec2(" + std::to_string(origin.x) + ".0, " + std::to_string(origin.y) + ".0)";
    switch (as.texture) {
        case texture::atlas: return name + (as.origin.empty() ? region : "");
        case texture::array:
        case texture::depth_array:
        case texture::shadow_array: return name + ", 1.0";
        case texture::cube: return name + ", 3.0";
        default: return name;
    }
}

std::vector<umbrage::glsl::bound> entry::items() const {
    std::vector<umbrage::glsl::bound> all;
    const std::vector<snippet> unbound = snippets();
    for (const bound_map& b : bound)
        for (const snippet& s : unbound) all.push_back(umbrage::glsl::bind(s, b.name, b.as));
    if (bound.empty()) all.assign(unbound.begin(), unbound.end());
    return all;
}

bool entry::runs_in(dialect d) const {
    if (!bound.empty() && d.in != dialect::glsl) return false;
    for (const bound_map& b : bound)  // no depth textures in WebGL 1
        if (b.as.texture == texture::depth && d.of_glsl < version::v130) return false;
    const auto all = items();
    return std::all_of(all.begin(), all.end(), [d](const auto& item) { return supports(item, d.of_glsl); });
}

std::array<sampler, max_textures> samplers(const entry& e) {
    std::array<sampler, max_textures> all;
    for (int i = 0; i < max_inputs; ++i)
        if (e.uses(i)) all[static_cast<std::size_t>(i)] = {"sampler2D", "x" + std::to_string(i) + "_texels"};
    if (!e.maps.empty() && e.bound.empty()) all[map_unit(0)] = {"sampler2D", "map"};
    for (std::size_t k = 0; k < e.bound.size(); ++k) {
        const std::string parameters(umbrage::glsl::detail::glsl_texture(e.bound[k].as.texture).parameters);
        const std::size_t type = parameters.find(' ') + 1;
        all[map_unit(k)] = {parameters.substr(type, parameters.find(' ', type) - type), e.bound[k].name};
    }
    if (!e.table.empty()) all[table_unit] = {"sampler2D", "table"};
    return all;
}

std::string map_size(const entry& e) {
    if (e.bound.empty()) return "vec2(textureSize(map, 0))";
    const bound_map& b = e.bound.front();
    const ivec2 less = b.is_region() ? bound_map::margin : ivec2(0);
    return "vec2(textureSize(" + b.name + ", 0)) - vec2(" + std::to_string(less.x) + ".0, " + std::to_string(less.y) +
           ".0)";
}

std::string macros(const entry& e) {
    std::string all = e.preamble;
    if (e.map_kind.direction == umbrage::depth_direction::reversed) all += "#define UMBRAGE_REVERSED\n";
    if (e.map_kind.outside_lit) all += "#define UMBRAGE_OUTSIDE_LIT\n";
    if (std::string depth = e.map_kind.depth; !depth.empty()) {
        const std::string value = "value.xy";
        depth.replace(depth.find(value), value.size(), "vec2(umbrage_fetch_clamped(map, size, texel))");
        all += "#define UMBRAGE_FETCH(map, size, texel) " + depth + '\n';
    }
    return all;
}

call_snippet::call_snippet(const entry& e) : needs_{e.primitive} {
    needs_.insert(needs_.end(), e.also.begin(), e.also.end());
    std::string parameters;
    const auto add = [&](const std::string& type, const std::string& name) {
        parameters += (parameters.empty() ? "" : ", ") + type + " " + name;
        arguments_ += (arguments_.empty() ? "" : ", ") + name;
    };
    for (int i = 0; i < max_inputs; ++i)
        if (e.uses(i)) add("vec4", "x" + std::to_string(i));
    if (e.call.find("(map,") != e.call.npos) add("UMBRAGE_MAP", "map");
    if (e.call.find("map_size") != e.call.npos) add("vec2", "map_size");
    if (!e.table.empty()) add("UMBRAGE_MAP", "table");
    source_ = "\nvec4 umbrage_call(" + parameters + ") {\n    return " + e.call + ";\n}\n";
    snippet call{.name = "call", .source = source_};
    call.needs.first = needs_.data();
    call.needs.size = needs_.size();
    items_.push_back(bind(call, "", e.map_kind));
}

std::string with_mistake(std::string text) {
    if (planted.from.empty()) return text;
    for (auto at = text.find(planted.from); at != text.npos; at = text.find(planted.from, at + planted.to.size()))
        text.replace(at, planted.from.size(), planted.to);
    return text;
}

shader make_shader(const entry& e, dialect d) {
    if (d == dialect::hlsl) return {"", with_mistake(make_hlsl(e))};
    if (d == dialect::wgsl) return {"", with_mistake(make_wgsl(e))};
    const version v = d.of_glsl;
    const bool old = v == version::v100 || v == version::v110 || v == version::v120;
    const bool es = v == version::v100 || v == version::v300_es || v == version::v310_es || v == version::v320_es;
    const bool vulkan = v == version::vulkan;
    const auto located = [&](const char* what) { return (vulkan ? "layout(location = 0) " : "") + std::string(what); };

    const std::vector<snippet> none;
    shader s;
    s.vertex = source(v, none) +
               (old ? "attribute vec2 corner;\nvarying UMBRAGE_HIGHP vec2 position;\n" : located("in vec2 corner;\n")) +
               "void main() {\n" + (old ? "    position = corner * 0.5 + 0.5;\n" : "") +
               "    gl_Position = vec4(corner, 0.0, 1.0);\n}\n";

    // A host shader of low precision: the snippets must ask for what they need.
    const std::string preamble = (es ? "precision mediump float;\nprecision mediump int;\n" : "") + macros(e);
    std::string& f = s.fragment;
    f = source(v, e.items(), preamble) + '\n';
    const auto all = samplers(e);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].name.empty()) continue;
        if (vulkan) f += "layout(set = 0, binding = " + std::to_string(i) + ") ";
        f += "uniform UMBRAGE_HIGHP " + all[i].type + " " + all[i].name + ";\n";
    }
    const bool map = !e.maps.empty();
    if (old && map) f += "uniform UMBRAGE_HIGHP vec2 map_size;\n";
    f += old ? "varying UMBRAGE_HIGHP vec2 position;\n" : located("out UMBRAGE_HIGHP vec4 result;\n");
    f += "void main() {\n";
    if (!old && map) f += "    UMBRAGE_HIGHP vec2 map_size = " + map_size(e) + ";\n";
    for (int i = 0; i < max_inputs; ++i) {
        if (!e.uses(i)) continue;
        const std::string x = "x" + std::to_string(i);
        f += "    UMBRAGE_HIGHP vec4 " + x + " = " +
             (old ? "texture2D(" + x + "_texels, position);\n"
                  : "texelFetch(" + x + "_texels, ivec2(gl_FragCoord.xy), 0);\n");
    }
    // gl_FragColor is mediump in GLSL ES 1.00. Mesa drops the rounding of a product that is stored as it is, but not of
    // a value that comes out of a branch: that it rounds in the branch.
    const std::string one = v == version::v100 ? " * (position.x < 2.0 ? 1.0 : 0.0)" : "";
    f += std::string("    ") + (old ? "gl_FragColor" : "result") + " = " + e.call + one + ";\n}\n";
    return s;
}

}  // namespace parity
