// SPDX-License-Identifier: MIT
//
// pcf_2x2 by the sampler: one look-up that compares four texels and weighs them.
//
//     float visibility = umbrage::pcf_2x2_hardware(umbrage::bordered(map), coord, depth - bias);
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
/// @exactness     C, within 1/128: either axis' weight is the hardware's, within 1/256 of ours. With b bits
///                of weight it is 2^(1 - b): Direct3D has 8, Vulkan at least 4 (subTexelPrecisionBits), others state
///                none
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_filtered(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return pcf_2x2(fetch, glm::clamp(coord, T(-32767), T(32767)), receiver, is_lit);
}

/// lit_filtered at a point in shares of the map's size: what a sampler takes, where the map is all of its texture.
/// @param size   of the map, in texels
/// @param uv     from (0, 0) to (1, 1) over the map, no NaN
/// @exactness    C, within 1/128, as lit_filtered
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_at(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv, T receiver, Compare is_lit = {}) {
    return lit_filtered(fetch, uv * size, receiver, is_lit);
}

/// What the sampler gives, but for the rounding of its weights: pcf_2x2.
/// @return        visibility, 0 in shadow, 1 lit
/// @exactness     C, within 1/128, as lit_filtered
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

/// Of a comparison sampler that a map has for itself the look-up as it is; where a map is a region, or lit outside, or
/// has no such sampler, lit_filtered.
inline constexpr snippet lit_at{
    .name = "lit_at",
    .summary = "comparisons around a point of the map, weighted",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&lit_filtered>,
    .role = hook::lit_at,
    .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted; visibility, 1.0 is lit
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
)GLSL",
};

inline constexpr snippet pcf_2x2_hardware{
    .name = "pcf_2x2_hardware",
    .summary = "2x2 by a comparison sampler with a linear filter",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&in_filter_domain, &within_far_plane, &lit_at>,
    .source = R"GLSL(
// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? coord : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_at(map, size, at / size, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL",
};

inline constexpr const snippet* pcf_2x2_hardware_snippets[]{&lit_filtered, &lit_at, &pcf_2x2_hardware};

}  // namespace glsl
}  // namespace umbrage
