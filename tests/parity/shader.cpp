// SPDX-License-Identifier: MIT
#include "shader.hpp"

namespace parity {

std::array<std::string, max_inputs + 2> samplers(const entry& e) {
    std::array<std::string, max_inputs + 2> names;
    for (int i = 0; i < max_inputs; ++i)
        if (e.uses(i)) names[static_cast<std::size_t>(i)] = "x" + std::to_string(i) + "_texels";
    if (!e.maps.empty()) names[max_inputs] = "map";
    if (!e.table.empty()) names[max_inputs + 1] = "table";
    return names;
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
    f = source(v, e.snippets(), preamble) + '\n';
    const auto names = samplers(e);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].empty()) continue;
        if (vulkan) f += "layout(set = 0, binding = " + std::to_string(i) + ") ";
        f += "uniform UMBRAGE_HIGHP sampler2D " + names[i] + ";\n";
    }
    const bool map = !e.maps.empty();
    if (old && map) f += "uniform UMBRAGE_HIGHP vec2 map_size;\n";
    f += old ? "varying UMBRAGE_HIGHP vec2 position;\n" : located("out UMBRAGE_HIGHP vec4 result;\n");
    f += "void main() {\n";
    if (!old && map) f += "    UMBRAGE_HIGHP vec2 map_size = vec2(textureSize(map, 0));\n";
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
