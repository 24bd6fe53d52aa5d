// SPDX-License-Identifier: MIT
//
// Bilinear 2x2 percentage-closer filtering (PCF) by a comparison sampler: one fetch compares and weights four texels.
//
//     float visibility = umbrage::pcf_2x2_hardware(umbrage::bordered(map), coord, depth - bias);
//
// In a shader, bind it to a `texture::shadow` or `texture::shadow_array` whose sampler filters linearly. For any other
// map it is `pcf_2x2`. The bound holds for samplers whose weights have steps of 1/256, as in Direct3D, or finer steps.
// OpenGL does not define how a linear filter treats comparisons: Mesa's softpipe compares a filtered depth.
// Also called: hardware PCF, sampler2DShadow, SampleCmp, textureSampleCompare.
// See also: pcf_2x2.hpp, exact on every GPU.
//
#pragma once

#include <umbrage/filter/pcf/pcf_2x2.hpp>

namespace umbrage {

/// Weighted comparisons around a point, as a linear comparison sampler returns them. Other maps use pcf_2x2.
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called 4 times
/// @param coord      in texels, no NaN. Outside texel space it is clamped
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @formula          pcf_2x2 at clamp(coord, -32767, 32767)
/// @exactness        C, within 1/128: the hardware's weight along each axis is within 1/256 of this one. With b bits
///                   of weight the bound is 2^(1 - b). Direct3D has 8, Vulkan at least 4 (subTexelPrecisionBits), other
///                   APIs state none
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_filtered(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return pcf_2x2(fetch, glm::clamp(coord, T(-32767), T(32767)), receiver, is_lit);
}

/// lit_filtered at a point in [0, 1] over the map, as a sampler takes it when the map fills its texture.
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called 4 times
/// @param size       size of the map, in texels
/// @param uv         from (0, 0) to (1, 1) over the map, no NaN
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @exactness        C, within 1/128, as lit_filtered
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_at(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv, T receiver, Compare is_lit = {}) {
    return lit_filtered(fetch, uv * size, receiver, is_lit);
}

/// Share of the texels around a point that lie in the map, along each axis. A fetch callable has texels everywhere.
/// @return        (1, 1). For a comparison sampler of a map that is lit outside, a shader has
///                clamp(1/2 + size / 2 - |uv - 1/2| size, 0, 1)
/// @exactness     C, n = 6
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> covered(glm::vec<2, T>, glm::vec<2, T>) {
    return glm::vec<2, T>(1);
}

/// lit_at of the texels in the map alone; covered() tells their share. In a shader it also takes the way from the
/// receiver to where the four texels meet, in texels, which a receiver's plane needs.
/// @exactness        C, within 1/128, as lit_filtered
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_between(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv, T receiver, Compare is_lit = {}) {
    return lit_filtered(fetch, uv * size, receiver, is_lit);
}

/// Bilinear 2x2 PCF as the sampler computes it, except for the rounding of its weights. Parameters as for pcf_2x2.
/// @return        visibility in [0, 1]: 0 in shadow, 1 lit
/// @exactness     C, within 1/128, as lit_filtered
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return pcf_2x2(fetch, coord, receiver, is_lit);
}

namespace glsl {

inline constexpr snippet lit_filtered{
    .name = "lit_filtered",
    .summary = "weighted comparisons around a point in texels",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&pcf_2x2>,
    .role = hook::lit_filtered,
    .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2(-32767.0, -32767.0), vec2(32767.0, 32767.0)), receiver);
}
)GLSL",
};

/// Share of each axis' texels around a point that lie in the map: 1 where texels outside are those of the edge, or
/// where lit_between counts them itself.
inline constexpr snippet covered{
    .name = "covered",
    .summary = "share of the texels around a point that lie in the map, along each axis",
    .exactness = tier::c,
    .operations = 6,
    .role = hook::covered,
    .source = R"GLSL(
// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP vec2 umbrage_covered(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return vec2(1.0, 1.0);
}
)GLSL",
};

/// Plain fetch of a map with its own comparison sampler, in the map alone. Uses lit_filtered where the map is a region
/// or has no such sampler.
inline constexpr snippet lit_between{
    .name = "lit_between",
    .summary = "weighted comparisons around a point, where four texels meet",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&lit_filtered>,
    .role = hook::lit_between,
    .source = R"GLSL(
// umbrage_lit_between: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   way   from the receiver to where the four texels meet, in texels. Only a receiver's plane uses it
UMBRAGE_HIGHP float umbrage_lit_between(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                        UMBRAGE_HIGHP vec2 way, UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
)GLSL",
};

inline constexpr snippet lit_at{
    .name = "lit_at",
    .summary = "weighted comparisons around a point in [0, 1]",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&covered, &lit_between>,
    .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 way = floor(uv * size + 0.5) - coord;
    UMBRAGE_HIGHP vec2 inside = umbrage_covered(size, uv);
    UMBRAGE_HIGHP float lit = umbrage_lit_between(map, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}
)GLSL",
};

inline constexpr snippet pcf_2x2_hardware{
    .name = "pcf_2x2_hardware",
    .summary = "bilinear 2x2 PCF by a linear comparison sampler",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&in_filter_domain, &within_far_plane, &lit_at>,
    .source = R"GLSL(
// umbrage_pcf_2x2_hardware: bilinear 2x2 PCF by the sampler. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? coord : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_at(map, size, at / size, at, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL",
};

inline constexpr const snippet* pcf_2x2_hardware_snippets[]{&lit_filtered, &covered, &lit_between, &lit_at,
                                                            &pcf_2x2_hardware};

}  // namespace glsl
}  // namespace umbrage
