// SPDX-License-Identifier: MIT
//
// Filters and codecs as people write them, with places for slips and for other ways to say the same.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace check {

/// What stands at the places of a filter's text.
struct filter_parts {
    std::string uv = "uv", texels = "size", added = "vec2(0.0)", receiver = "z", lit = "r <= d ? 1.0 : 0.0",
                result = "v";
};

/// A known function: its name here, and its body over lit(texel, r), with `at` in texels.
struct written_filter {
    std::string_view name, body;
};

inline constexpr written_filter written_filters[]{
    {"hard", "v = lit(ivec2(floor(at)), r);"},
    {"box(1)",
     R"(for (int j = -1; j <= 1; ++j) for (int i = -1; i <= 1; ++i) v += lit(ivec2(floor(at)) + ivec2(i, j), r);
    v = v * (1.0 / 9.0);)"},
    {"pcf_2x2", R"(vec2 p = floor(at * 256.0) - 128.0, t = floor(p / 256.0), f = p / 256.0 - t; ivec2 k = ivec2(t);
    v = (1.0 - f.y) * ((1.0 - f.x) * lit(k, r) + f.x * lit(k + ivec2(1, 0), r))
      + f.y * ((1.0 - f.x) * lit(k + ivec2(0, 1), r) + f.x * lit(k + ivec2(1, 1), r));)"},
    {"tent3", R"(vec2 p = floor(at * 256.0) - 128.0, t = floor(p / 256.0), f = p / 256.0 - t; ivec2 k = ivec2(t);
    vec4 x = vec4(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x), y = vec4(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y);
    for (int j = 0; j < 4; ++j) for (int i = 0; i < 4; ++i) v += x[i] * y[j] * lit(k + ivec2(i - 1, j - 1), r);
    v = v / 16.0;)"},
};

inline std::string filter_text(std::string_view body, const filter_parts& p) {
    return R"(#version 330
uniform sampler2D shadowMap;
float lit(ivec2 texel, float r) {
    ivec2 last = textureSize(shadowMap, 0) - 1;
    float d = texelFetch(shadowMap, clamp(texel, ivec2(0), last), 0).r;
    return )" +
           p.lit + R"(;
}
float shadow(vec2 uv, float z) {
    vec2 size = vec2(textureSize(shadowMap, 0));
    vec2 at = )" +
           p.uv + " * " + p.texels + " + " + p.added + R"(;
    float r = )" +
           p.receiver + R"(, v = 0.0;
    )" + std::string(body) +
           R"(
    return )" +
           p.result + ";\n}\n";
}

/// A slip at one of those places, and the word by which it is to be named.
struct planted_slip {
    std::string filter_parts::*where;
    std::string_view text, kind;
};

inline const planted_slip filter_slips[]{
    {&filter_parts::added, "vec2(0.5)", "shift"},
    {&filter_parts::added, "vec2(-0.5, 0.0)", "shift"},
    {&filter_parts::added, "vec2(1.0)", "shift"},
    {&filter_parts::added, "vec2(0.0, -1.0)", "shift"},
    {&filter_parts::added, "vec2(2.0, 1.0)", "shift"},
    {&filter_parts::uv, "vec2(uv.x, 1.0 - uv.y)", "flip"},
    {&filter_parts::uv, "vec2(1.0 - uv.x, uv.y)", "flip"},
    {&filter_parts::uv, "uv.yx", "swap"},
    {&filter_parts::uv, "(uv * 0.5 + 0.5)", "uv_range"},
    {&filter_parts::uv, "(uv * 2.0 - 1.0)", "uv_range"},
    {&filter_parts::receiver, "z * 2.0 - 1.0", "z_range"},
    {&filter_parts::receiver, "z * 0.5 + 0.5", "z_range"},
    {&filter_parts::receiver, "1.0 - z", "direction"},
    {&filter_parts::receiver, "z + 0.005", "bias"},
    {&filter_parts::receiver, "z - 0.002", "bias"},
    {&filter_parts::lit, "r < d ? 1.0 : 0.0", "strict"},
    {&filter_parts::lit, "r >= d ? 1.0 : 0.0", "direction"},
    {&filter_parts::result, "1.0 - v", "in_shadow"},
    {&filter_parts::result, "0.7 * v", "levels"},
};

}  // namespace check
