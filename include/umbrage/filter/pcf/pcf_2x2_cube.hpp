// SPDX-License-Identifier: MIT
//
// Bilinear percentage-closer filtering (PCF) over 2 x 2 texels of a cube map stored as tiles of an atlas. Taps cross
// the edges of faces, so no seam shows.
//
//     glm::vec3 at = umbrage::cube_coordinate(world - light) * glm::vec3(size, size, 1);
//     float visibility = umbrage::pcf_2x2_cube(umbrage::clamped(atlas), float(size), at, depth);
//
// In a shader, bind it to an atlas without options, or to a cube texture:
//
//     glsl::source(glsl::version::v330, {glsl::cube_coordinate,
//                                        bind(glsl::pcf_2x2_cube, "point_light", {.texture = texture::cube_faces})});
//     // vec2 atlas = vec2(3.0, 2.0) * float(size); umbrage_pcf_2x2_cube_point_light(point_light, atlas, at, depth)
//
// Depths must not depend on the face: store distances from the light, as `distance_depth` computes them.
// Also called: seamless point light shadows, samplerCubeShadow, TextureCube SampleCmp.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/light/point/cube_map.hpp>

namespace umbrage {

/// Visibility from one comparison with a texel of a cube map. The texel may lie beyond an edge of its face.
/// @param fetch      returns the stored depth of a texel of the atlas: float(glm::ivec2). Tiles lie as from cube_tile
/// @param size       edge of a face, in texels
/// @param texel      (s, t, face), integers
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           (1 when lit or 0 in shadow, 1)
/// @edge             beyond a corner, where there is no texel: (0, 0)
/// @exactness        A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> cube_lit(Fetch&& fetch, T size, glm::vec<3, T> texel, T receiver, Compare is_lit = {}) {
    const glm::vec<3, T> n = cube_neighbor(texel, size);
    if (n.z < T(0)) return {T(0), T(0)};
    const glm::ivec2 first = cube_tile(static_cast<int>(n.z), static_cast<int>(size));
    return {lit(fetch, first + glm::ivec2(n), receiver, is_lit), T(1)};
}

/// Fraction of the light that reaches a receiver, from the four nearest texels on any face.
///
/// Each texel is compared, then weighted. A corner has only three texels, whose weights are scaled to sum to 1.
/// @param fetch      returns the stored depth of a texel of the atlas: float(glm::ivec2). Tiles as cube_tile places
///                   them. Called up to 4 times
/// @param size       edge of a face, in texels
/// @param at         (s, t, face): s and t in texels, from 0 to size
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1], the same on both sides of an edge
/// @edge             NaN in at: 1. Receiver beyond the far plane: 1. NaN receiver: 0
/// @formula          sum of w_i [receiver <= fetch(texel_i)] over sum of w_i, w the bilinear weights in steps of 1/256,
///                   to the nearest step, which is the same one from both sides
/// @exactness        C, n = 33: a division, by 1 except at corners. S is at most 81 / (sum of w_i)^2
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2_cube(Fetch&& fetch, T size, glm::vec<3, T> at, T receiver, Compare is_lit = {}) {
    const glm::vec<2, T> coord(at);
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> x = glm::floor(coord * T(256) + T(0.5)) - T(128);
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0));
    const glm::vec<2, T> hi = glm::clamp(x * T(1.0 / 256.0) - texel, T(0), T(1)), lo = T(1) - hi;
    const auto tap = [&](T i, T j) {
        return cube_lit(fetch, size, glm::vec<3, T>(texel.x + i, texel.y + j, at.z), receiver, is_lit);
    };
    glm::vec<2, T> sum = tap(T(0), T(0)) * (lo.x * lo.y);
    sum += tap(T(1), T(0)) * (hi.x * lo.y);
    sum += tap(T(0), T(1)) * (lo.x * hi.y);
    sum += tap(T(1), T(1)) * (hi.x * hi.y);
    return sum.y > T(0) ? sum.x / sum.y : T(1);
}

namespace glsl {

inline constexpr snippet cube_lit{
    .name = "cube_lit",
    .summary = "one comparison with a texel of a cube map",
    .exactness = tier::a,
    .needs = list<&cube_neighbor, &cube_tile, &lit>,
    .source = R"GLSL(
// umbrage_cube_lit: one comparison with a texel of a cube map
// Returns (visibility, 1.0), or (0.0, 0.0) beyond a corner
//   map, size   atlas of 3 x 2 faces and its size in texels
//   texel       (s, t, face), integers
//   receiver    distance from the light, bias applied
UMBRAGE_HIGHP vec2 umbrage_cube_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 texel,
                                    UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float side = size.y * 0.5;
    UMBRAGE_HIGHP vec3 n = umbrage_cube_neighbor(texel, side);
    UMBRAGE_HIGHP vec2 at = umbrage_cube_tile(n.z, side) + vec2(n.x, n.y);
    UMBRAGE_HIGHP float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? vec2(0.0, 0.0) : vec2(lit, 1.0);
}
)GLSL",
};

inline constexpr snippet pcf_2x2_cube{
    .name = "pcf_2x2_cube",
    .summary = "bilinear 2x2 PCF of a cube map, across its edges",
    .exactness = tier::c,
    .operations = 33,
    .needs = list<&in_filter_domain, &cube_lit>,
    .source = R"GLSL(
// umbrage_pcf_2x2_cube: bilinear 2x2 PCF across the edges of a cube map. Returns visibility, 1.0 = lit
//   map, size   atlas of 3 x 2 faces and its size in texels
//   at          (s, t, face): s and t in texels of the face, from 0.0 on
//   receiver    distance from the light, bias applied
UMBRAGE_HIGHP float umbrage_pcf_2x2_cube(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 at,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 coord = vec2(at.x, at.y);
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0 + 0.5) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 lo = 1.0 - hi;
    UMBRAGE_HIGHP vec2 sum = umbrage_cube_lit(map, size, vec3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
}
)GLSL",
};

inline constexpr const snippet* pcf_2x2_cube_snippets[]{&cube_lit, &pcf_2x2_cube};

}  // namespace glsl
}  // namespace umbrage
