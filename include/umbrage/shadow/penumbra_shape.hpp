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
// Under a warp a ray of the light keeps its w. So the depth between a caster and its receiver, and the width of the
// penumbra in texels, both go with 1 / w. Under LiSPSM and TSM w varies along the map's y alone. What is left of their
// ratio is then linear in the texel's row, and the shear is linear in its column. Under PSM w also varies a little
// along x, which these numbers leave out.
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
/// @param warps    one column per map: its factor in y is x + y times the row, its shear z + w times the column
/// @param number   number of the map, an integer from 0 to 3
/// @param at       place in the map, texels
/// @return         factors of the map's softness in x, which is 1, and in y; shear from -2 to 2
/// @exactness      B, n = 2
template <real T>
[[nodiscard]] glm::vec<3, T> warp_shape(const glm::mat<4, 4, T>& warps, T number, glm::vec<2, T> at) {
    const glm::vec<4, T> own = cascade_column(warps, number);
    return {T(1), own.x + own.y * at.y, (glm::clamp)(own.z + own.w * at.x, T(-2), T(2))};
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

/// Numbers of a map for warp_shape: a column of it. (1, 0, 0, 0) where no warp changes the shape.
/// @param m   texture matrix of the map
[[nodiscard]] inline glm::vec4 warp_of(const glm::dmat4& m, glm::ivec2 map_size) {
    // d(texel) / d(world across the light) is (x - column w, y - row w) / w, of the matrix' rows x, y and w.
    const glm::dvec3 way = glm::normalize(direction_of(m)), x = row_of(m, 0), y = row_of(m, 1), w = row_of(m, 3);
    const auto across = [&](const glm::dvec3& v) { return v - way * glm::dot(way, v); };
    const glm::dvec2 size(map_size);
    const glm::dvec3 middle = across(y - 0.5 * size.y * w);
    const auto factor = [&](double row) { return glm::dot(across(y - row * w), middle) / glm::dot(middle, middle); };
    const auto shear = [&](double column) {
        const glm::dvec3 a = across(x - column * w);
        return glm::dot(a, middle) / glm::length(glm::cross(a, middle));
    };
    const glm::dvec4 all(factor(0), (factor(size.y) - factor(0)) / size.y, shear(0),
                         (shear(size.x) - shear(0)) / size.x);
    const bool changes = std::abs(all.y * size.y) > 1e-6 || std::abs(all.z) > 1e-6 || std::abs(all.w * size.x) > 1e-6;
    return changes ? glm::vec4(all) : glm::vec4(1, 0, 0, 0);
}

}  // namespace detail

namespace glsl {

inline constexpr snippet warp_shape{
    .name = "warp_shape",
    .summary = "shape of penumbras at a texel of a warped map",
    .exactness = tier::b,
    .operations = 2,
    .needs = list<&cascade_column>,
    .source = R"GLSL(
// umbrage_warp_shape: shape of penumbras at a texel of a warped map
//   warps    one column per map: its factor in y is x + y times the row, its shear z + w times the column
//   number   number of the map
//   at       place in the map, texels
//   returns factors of the map's softness in x and y, and the shear
UMBRAGE_HIGHP vec3 umbrage_warp_shape(UMBRAGE_HIGHP mat4 warps, UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 at) {
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(warps, number);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float factor = own.x + own.y * at.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float shear = own.z + own.w * at.x;
    return vec3(1.0, factor, clamp(shear, -2.0, 2.0));
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
