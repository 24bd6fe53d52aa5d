// SPDX-License-Identifier: MIT
//
// pcf_2x2 by the sampler: one look-up that compares four texels and weighs them.
//
//     float visibility = umbrage::pcf_2x2_hardware(umbrage::clamped(map), coord, depth - bias);
//
// In a shader bind it to a texture::shadow or texture::shadow_array whose sampler filters linearly; for any other map
// it is pcf_2x2. The bound holds for samplers that weigh in steps of 1/256, as Direct3D has them, or finer. OpenGL
// leaves what a linear filter does to comparisons to the implementation: Mesa's softpipe compares a filtered depth.
//
#pragma once

#include <umbrage/filter/pcf/pcf_2x2.hpp>

namespace umbrage {

/// What filters ask of a map whose sampler weighs comparisons, and what other maps give in its place: pcf_2x2.
/// @param coord   no NaN; what is outside texel space counts as its border
/// @formula       pcf_2x2 at clamp(coord, -32767, 32767)
/// @exactness     C, within 1/128 in a shader: either axis' weight is the hardware's, within 1/256 of ours
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_filtered(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return pcf_2x2(fetch, glm::clamp(coord, T(-32767), T(32767)), receiver, is_lit);
}

/// What the sampler gives, but for the rounding of its weights: pcf_2x2.
/// @return        visibility, 0 in shadow, 1 lit
/// @exactness     C, within 1/128 in a shader, as lit_filtered
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return pcf_2x2(fetch, coord, receiver, is_lit);
}

namespace glsl {

inline constexpr snippet lit_filtered{
    .name = "lit_filtered",
    .summary = "comparisons around a point, weighted",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&pcf_2x2>,
    .role = hook::lit_filtered,
    .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point; this map has no sampler to weigh them; visibility, 1.0 is lit
//   coord  in texels, no NaN; what is outside texel space counts as its border
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2(-32767.0, -32767.0), vec2(32767.0, 32767.0)), receiver);
}
)GLSL",
};

inline constexpr snippet pcf_2x2_hardware{
    .name = "pcf_2x2_hardware",
    .summary = "2x2 by a comparison sampler with a linear filter",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&is_compared, &lit_filtered>,
    .source = R"GLSL(
// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? coord : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_filtered(map, size, at, receiver);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr auto pcf_2x2_hardware_snippets = list<&lit_filtered, &pcf_2x2_hardware>;

}  // namespace glsl
}  // namespace umbrage
