// SPDX-License-Identifier: MIT
//
// Filters as people write them, with places for slips and for other ways to say the same.
#pragma once

#include <string>
#include <string_view>

#include "languages.hpp"

namespace check {

/// What stands at the places of a filter's text.
struct filter_parts {
    std::string uv = "uv", texels = "size", added = "vec2(0.0, 0.0)", receiver = "z", lit = "r <= d ? 1.0 : 0.0",
                result = "v";
};

[[nodiscard]] inline filter_parts plain_parts(const language& in) { return {.lit = in.one_if("r <= d")}; }

/// A known function: its name here, and its body over lit(texel, r), with `at` in texels. It sets v.
struct written_filter {
    std::string_view name, body, in_wgsl{};
};

inline constexpr written_filter written_filters[]{
    {"hard", "v = lit(ivec2(floor(at)), r);", "v = lit(vec2i(floor(at)), r);"},
    {"box(1)",
     R"(for (int j = -1; j <= 1; ++j) for (int i = -1; i <= 1; ++i) v += lit(ivec2(floor(at)) + ivec2(i, j), r);
    v = v * (1.0 / 9.0);)",
     R"(for (var j = -1; j <= 1; j++) { for (var i = -1; i <= 1; i++) { v += lit(vec2i(floor(at)) + vec2i(i, j), r); } }
    v = v * (1.0 / 9.0);)"},
    {"pcf_2x2", R"(vec2 p = floor(at * 256.0) - 128.0, t = floor(p / 256.0), f = p / 256.0 - t; ivec2 k = ivec2(t);
    v = (1.0 - f.y) * ((1.0 - f.x) * lit(k, r) + f.x * lit(k + ivec2(1, 0), r))
      + f.y * ((1.0 - f.x) * lit(k + ivec2(0, 1), r) + f.x * lit(k + ivec2(1, 1), r));)",
     R"(let p = floor(at * 256.0) - 128.0; let t = floor(p / 256.0); let f = p / 256.0 - t; let k = vec2i(t);
    v = (1.0 - f.y) * ((1.0 - f.x) * lit(k, r) + f.x * lit(k + vec2i(1, 0), r))
      + f.y * ((1.0 - f.x) * lit(k + vec2i(0, 1), r) + f.x * lit(k + vec2i(1, 1), r));)"},
    {"tent3", R"(vec2 p = floor(at * 256.0) - 128.0, t = floor(p / 256.0), f = p / 256.0 - t; ivec2 k = ivec2(t);
    vec4 x = vec4(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x), y = vec4(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y);
    for (int j = 0; j < 4; ++j) for (int i = 0; i < 4; ++i) v += x[i] * y[j] * lit(k + ivec2(i - 1, j - 1), r);
    v = v / 16.0;)",
     R"(let p = floor(at * 256.0) - 128.0; let t = floor(p / 256.0); let f = p / 256.0 - t; let k = vec2i(t);
    var x = vec4f(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x);
    var y = vec4f(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y);
    for (var j = 0; j < 4; j++) { for (var i = 0; i < 4; i++) { v += x[i] * y[j] * lit(k + vec2i(i - 1, j - 1), r); } }
    v = v / 16.0;)"},
};

/// Call of the function in filter_text().
[[nodiscard]] inline std::string filter_call(const language& in) {
    return in.is_msl() ? "shadow(map, uv, z)" : "shadow(uv, z)";
}

/// Text whose function shadow(uv, z) is the filter, over the map `shadowMap`. In Metal the map is an
/// argument.
[[nodiscard]] inline std::string filter_text(const language& in, const written_filter& filter, const filter_parts& p) {
    const std::string at = p.uv + " * " + p.texels + " + " + p.added;
    if (in.is_wgsl())
        return R"(fn lit(texel: vec2i, r: f32) -> f32 {
    let last = vec2i(textureDimensions(shadowMap)) - 1;
    let d = textureLoad(shadowMap, clamp(texel, vec2i(0), last), 0).r;
    return )" + p.lit +
               ";\n}\nfn shadow(uv: vec2f, z: f32) -> f32 {\n    let size = vec2f(textureDimensions(shadowMap));\n" +
               "    let at = " + at + ";\n    let r = " + p.receiver + ";\n    var v = 0.0;\n    " +
               std::string(filter.in_wgsl) + "\n    return " + p.result + ";\n}\n";
    const std::string map = in.is_msl() ? "texture2d<float> depths, " : "";
    const std::string load =
        in.is_msl() ? "#define map_size() vec2(depths.get_width(), depths.get_height())\n"
                      "#define load(texel) depths.read(uint2(texel)).r\n"
                      "#define lit(texel, r) lit_at(depths, texel, r)\n"
        : in.in == parity::dialect::hlsl
            ? "vec2 map_size() { vec2 size; shadowMap.GetDimensions(size.x, size.y); return size; }\n"
              "float load(ivec2 texel) { return shadowMap.Load(int3(texel, 0)).r; }\n"
            : "uniform sampler2D shadowMap;\n"
              "vec2 map_size() { return vec2(textureSize(shadowMap, 0)); }\n"
              "float load(ivec2 texel) { return texelFetch(shadowMap, texel, 0).r; }\n";
    return std::string(in.preamble) + load + "float " + (in.is_msl() ? "lit_at" : "lit") + '(' + map +
           R"(ivec2 texel, float r) {
    float d = load(clamp(texel, ivec2(0, 0), ivec2(map_size()) - 1));
    return )" +
           p.lit + ";\n}\nfloat shadow(" + map +
           "vec2 uv, float z) {\n    vec2 size = map_size();\n    vec2 at = " + at + ";\n    float r = " + p.receiver +
           ", v = 0.0;\n    " + std::string(filter.body) + "\n    return " + p.result + ";\n}\n";
}

/// A slip at one of those places, and the word by which it is to be named. Of `lit` it is the condition.
struct planted_slip {
    std::string filter_parts::*where;
    std::string_view text, kind;
    void plant(const language& in, filter_parts& p) const {
        p.*where = where == &filter_parts::lit ? in.one_if(text) : std::string(text);
    }
};

inline const planted_slip filter_slips[]{
    {&filter_parts::added, "vec2(0.5, 0.5)", "shift"},     {&filter_parts::added, "vec2(-0.5, 0.0)", "shift"},
    {&filter_parts::added, "vec2(1.0, 1.0)", "shift"},     {&filter_parts::added, "vec2(0.0, -1.0)", "shift"},
    {&filter_parts::added, "vec2(2.0, 1.0)", "shift"},     {&filter_parts::uv, "vec2(uv.x, 1.0 - uv.y)", "flip"},
    {&filter_parts::uv, "vec2(1.0 - uv.x, uv.y)", "flip"}, {&filter_parts::uv, "uv.yx", "swap"},
    {&filter_parts::uv, "(uv * 0.5 + 0.5)", "uv_range"},   {&filter_parts::uv, "(uv * 2.0 - 1.0)", "uv_range"},
    {&filter_parts::receiver, "z * 2.0 - 1.0", "z_range"}, {&filter_parts::receiver, "z * 0.5 + 0.5", "z_range"},
    {&filter_parts::receiver, "1.0 - z", "direction"},     {&filter_parts::receiver, "z + 0.005", "bias"},
    {&filter_parts::receiver, "z - 0.002", "bias"},        {&filter_parts::lit, "r < d", "strict"},
    {&filter_parts::lit, "r >= d", "direction"},           {&filter_parts::result, "1.0 - v", "in_shadow"},
    {&filter_parts::result, "0.7 * v", "levels"},
};

}  // namespace check
