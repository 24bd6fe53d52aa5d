// SPDX-License-Identifier: MIT
//
// Shape of penumbras at a place of a map: factors of the map's softness along x and y, and a shear of x by y. A warp
// (LiSPSM, TSM, PSM) has smaller and more slanted texels from place to place. A tetrahedron's map has two shapes
// (tetrahedron_shape), other maps have one.
//
//     const glm::vec3 shape = umbrage::warp_shape(warps, 0.0f, coord);  // factors in x and y, shear
//     const glm::vec4 soft = umbrage::shaped_softness(glm::vec4(softness), shape);
//     const glm::vec4 rotation = umbrage::sheared_rotation(umbrage::disc_rotation(pixel), shape.z);
//
// Under a warp a sun's ray keeps its w. So the depth between a caster and its receiver, and the width of the penumbra
// in texels, both go with 1 / w. What is left of their ratio is linear in the texel: the rows
//
//     a = (1, shear) - x change      and      b = (0, 1) - y ratio change
//
// are what a step across the light adds to x and y of the map, in units of its first texel's: `change` is that of w.
// Their ellipse has the radii |a x b| / |b| and |b|, and the shear a . b / |a x b|. Where rays meet, both go with the
// difference of 1 / w, whatever the texel: a warped point light has one shear, and no change across its axis.
// See also: softness.hpp, filter/pcf/disc_tap.hpp.
#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/shadow/map_slack.hpp>

namespace umbrage {

/// Shape of penumbras at a texel of a warped map.
/// @param warps    one column per map: (change of w along both axes, shear, ratio) of its texel (0, 0), as above
/// @param number   number of the map, an integer from 0 to 3
/// @param at       place in the map, texels
/// @return         factors of the map's softness in x and y, which are 1 at (0, 0); shear from -8 to 8
/// @exactness      C, n = 29
template <real T>
[[nodiscard]] glm::vec<3, T> warp_shape(const glm::mat<4, 4, T>& warps, T number, glm::vec<2, T> at) {
    const glm::vec<4, T> own = cascade_column(warps, number);
    const glm::vec<2, T> a(T(1) - at.x * own.x, own.z - at.x * own.y),
        b(T(0) - at.y * own.w * own.x, T(1) - at.y * own.w * own.y);
    const T area = glm::abs(a.x * b.y - a.y * b.x), rows = std::sqrt(b.x * b.x + b.y * b.y);
    return {area / rows, rows, (glm::clamp)((a.x * b.x + a.y * b.y) / area, T(-8), T(8))};
}

/// Softness at a place of a map. Its largest radius shrinks with the shear, so that no point lies farther along x than
/// a disc's farthest point.
/// @param softness   (per_code_x, per_code_y, min_radius, max_radius) of the map
/// @param shape      factors in x and y, shear
/// @formula          max_radius / sqrt(1 + shear^2)
/// @exactness        C, n = 9
template <real T>
[[nodiscard]] glm::vec<4, T> shaped_softness(glm::vec<4, T> softness, glm::vec<3, T> shape) {
    return {softness.x * shape.x, softness.y * shape.y, softness.z, softness.w / std::sqrt(T(1) + shape.z * shape.z)};
}

namespace detail {

/// Numbers of a map for warp_shape: a column of it. (0, 0, 0, 1) where all its texels have one shape, a rectangle's.
/// @param m   texture matrix of the map
[[nodiscard]] inline glm::vec4 warp_of(const glm::dmat4& m, glm::ivec2 map_size) {
    // A step v across the light adds ((x - column w) v, (y - row w) v) / w texels, of the matrix' rows x, y and w.
    const auto sides = across(unit(direction_of(m)));
    const auto part = [&](glm::length_t row) {
        const glm::dvec3 all = row_of(m, row);
        return glm::dvec2(glm::dot(all, sides[0]), glm::dot(all, sides[1]));
    };
    const glm::dvec2 x = part(0), y = part(1), w = part(3), ahead = glm::normalize(y);
    const glm::dvec2 aside = glm::dvec2(ahead.y, -ahead.x) * (x.x * ahead.y < x.y * ahead.x ? -1.0 : 1.0);
    const double wide = glm::dot(x, aside);
    const glm::dvec4 all(glm::dvec3(glm::dot(w, aside), glm::dot(w, ahead), glm::dot(x, ahead)) / wide,
                         wide / glm::length(y));
    const double most = (glm::max)(std::abs(all.x), std::abs(all.y)) * (glm::max)(map_size.x, map_size.y);
    return most > 1e-4 || std::abs(all.z) > 1e-4 ? glm::vec4(all) : glm::vec4(0, 0, 0, 1);
}

}  // namespace detail

namespace glsl {

inline constexpr snippet warp_shape{
    .name = "warp_shape",
    .summary = "shape of penumbras at a texel of a warped map",
    .exactness = tier::c,
    .operations = 29,
    .needs = list<&cascade_column>,
    .source = R"GLSL(
// umbrage_warp_shape: shape of penumbras at a texel of a warped map
//   warps    one column per map: (change of w along both axes, shear, ratio) of its texel (0, 0)
//   number   number of the map
//   at       place in the map, texels
//   returns factors of the map's softness in x and y, and the shear
UMBRAGE_HIGHP vec3 umbrage_warp_shape(UMBRAGE_HIGHP mat4 warps, UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 at) {
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(warps, number);
    UMBRAGE_HIGHP vec2 a = vec2(1.0 - at.x * own.x, own.z - at.x * own.y);
    UMBRAGE_HIGHP vec2 b = vec2(-at.y * own.w * own.x, 1.0 - at.y * own.w * own.y);
    UMBRAGE_HIGHP float area = abs(a.x * b.y - a.y * b.x);
    UMBRAGE_HIGHP float rows = length(b);
    return vec3(area / rows, rows, clamp(dot(a, b) / area, -8.0, 8.0));
}
)GLSL",
};

inline constexpr snippet shaped_softness{
    .name = "shaped_softness",
    .summary = "softness of a place, by its shape",
    .exactness = tier::c,
    .operations = 9,
    .source = R"GLSL(
// umbrage_shaped_softness: softness of a place
//   softness   that of its map: (1/16 texel per distance code along x and y, min_radius, max_radius)
//   shape      factors in x and y, shear
UMBRAGE_HIGHP vec4 umbrage_shaped_softness(UMBRAGE_HIGHP vec4 softness, UMBRAGE_HIGHP vec3 shape) {
    UMBRAGE_HIGHP float max_radius = softness.w / sqrt(1.0 + shape.z * shape.z);
    return vec4(softness.x * shape.x, softness.y * shape.y, softness.z, max_radius);
}
)GLSL",
};

inline constexpr const snippet* penumbra_shape_snippets[]{&warp_shape, &shaped_softness};

}  // namespace glsl
}  // namespace umbrage
