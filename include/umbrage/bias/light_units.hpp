// SPDX-License-Identifier: MIT
//
// Conversion between texels, world units and depth at a point, for directional, spot and point lights alike.
//
//     glm::vec2 units = umbrage::make_light_units(light, map.size());
//     float w = umbrage::shadow_coordinate(to_texels, world).w;  // 1 for a directional light; a cube's cube_view_z
//     float bias = umbrage::world_to_depth(0.02f, units, w);     // two centimeters
//
// A texel's footprint across the light grows with w, the distance along a spot's axis. Depth per world unit falls with
// 1 / w^2. A directional light has w = 1 everywhere.
//
// In a warped map both change from point to point. Depth also drifts: it changes from texel to texel at one distance.
// There a bias in world units moves the point before its lookup, in the same way in every GLSL dialect:
//
//     auto here = umbrage::light_units_at(to_texels, light_direction, world);
//     float width = umbrage::offset_width(filter.reach(), here.units.x);
//     float bias_world = umbrage::kernel_bias(normal, light_direction, light_direction, width, 20.0f) +
//                        filter.reach() * here.drift_world;
//     glm::vec4 looked_up = umbrage::shadow_coordinate(to_texels, world - bias_world * light_direction);
//
// `acne_free_bias` with `plane_slope` does not need this, in shaders either.
#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/light/texel_units.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// World size of a texel and depth per world unit, for a light at w = 1.
///
/// @param light      light without a warp
/// @param map_size   map size in texels, each >= 1
/// @return           x: longer edge of a texel's footprint across the light, world units.
///                   y: depth z/w per world unit along the light
/// @throws std::invalid_argument  map_size below 1; clip unset; a warped map; units that are not finite and above 0
template <real T>
[[nodiscard]] glm::vec<2, T> make_light_units(const light_space<T>& light, glm::ivec2 map_size) {
    const glm::vec<3, T> units = detail::texel_units(light, map_size, "make_light_units");
    return {(glm::max)(units.x, units.y), units.z};
}

/// World size of a texel and depth per world unit, for a point light's cube at w = 1.
/// @param light   point light. All faces have the same units, and w is cube_view_z, the distance along a face's axis
/// @return        as for a light_space
/// @throws std::invalid_argument  a light that make_point_light refuses; units that are not finite and above 0
template <real T>
[[nodiscard]] glm::vec<2, T> make_light_units(const point_light<T>& light) {
    return make_light_units(make_point_light(light)[0], glm::ivec2(light.map_size));
}

/// Sizes that a bias is measured with, at a point of a map.
template <real T>
struct light_measures {
    glm::vec<2, T> units{T(0)};  ///< as from make_light_units, for a w of 1 at every point. x is the longest edge of
                                 ///< the texel's footprint across the light
    T drift_world = T(0);        ///< change of depth at one distance along the light, over one texel in x and one in y,
                                 ///< world units; 0 unless the map is warped
};

/// World size of a texel, depth per world unit, and drift at a point. The map may be warped.
///
/// @param texture_matrix   matrix from the world to texels
/// @param direction        direction of the light, or of a spot's axis, any length > 0
/// @param world            world position of the point, where the map's w is above 0
/// @formula                units.x: 1 / the smallest singular value of J = d(texel) / d(world across the light).
///                         units.y: |d(depth) / d(world)| along the light.
///                         drift_world: |J^-T d(depth) / d(world across the light)|_1 / units.y
template <real T>
[[nodiscard]] light_measures<T> light_units_at(const glm::mat<4, 4, T>& texture_matrix, glm::vec<3, T> direction,
                                               glm::vec<3, T> world) {
    const glm::vec<3, T> along = detail::unit(direction);
    const auto sides = detail::across(along);
    const glm::vec<3, T> a = detail::step(texture_matrix, world, sides[0]),
                         b = detail::step(texture_matrix, world, sides[1]);
    const T depth = glm::abs(detail::step(texture_matrix, world, along).z), area = glm::abs(a.x * b.y - a.y * b.x);
    const T longest = (std::hypot(a.x + b.y, a.y - b.x) + std::hypot(a.x - b.y, a.y + b.x)) / T(2);
    const T drift = (glm::abs(a.z * b.y - b.z * a.y) + glm::abs(b.z * a.x - a.z * b.x)) / area;
    return {{longest / area, depth}, drift / depth};
}

/// Length in texels across the light, converted to world units.
///
/// @param texels  length in the map, in texels
/// @param units   result of make_light_units
/// @param w       w of the point's shadow_coordinate
/// @return        world units, 2^-64 to 2^64
/// @edge          result out of range, w <= 0, or NaN: 0
/// @formula       texels units.x w
/// @exactness     B, n = 2: two products
template <real T>
[[nodiscard]] constexpr T texels_to_world(T texels, glm::vec<2, T> units, T w) {
    const T world = texels * units.x * w;
    return !is_nan(world) && world >= T(0x1p-64) && world < T(0x1p64) ? world : T(0);
}

/// Length in world units along the light, converted to depth z/w.
///
/// @param world   length along the light, world units
/// @param units   result of make_light_units
/// @param w       w of the point's shadow_coordinate, > 0
/// @return        depth, 0 to 1
/// @edge          w = 0 or NaN: 1
/// @formula       world units.y / w^2, the slope of z/w at the point
/// @accuracy      for a spot light, depth changes faster near the light. A point moved towards it by `world` changes
///                its depth by w / (w - world) times the result, which covers a bias
/// @exactness     C, n = 5: one division
template <real T>
[[nodiscard]] constexpr T world_to_depth(T world, glm::vec<2, T> units, T w) {
    return clamp_bias(world * units.y / (w * w));
}

namespace glsl {

inline constexpr snippet texels_to_world{
    .name = "texels_to_world",
    .summary = "texels across a light to world units",
    .exactness = tier::b,
    .operations = 2,
    .source = R"GLSL(
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate
UMBRAGE_HIGHP float umbrage_texels_to_world(UMBRAGE_HIGHP float texels, UMBRAGE_HIGHP vec2 units,
                                            UMBRAGE_HIGHP float w) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float world = texels * units.x * w;
    return world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0 ? world : 0.0;
}
)GLSL",
};

inline constexpr snippet world_to_depth{
    .name = "world_to_depth",
    .summary = "world units along a light to depth",
    .exactness = tier::c,
    .operations = 5,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate, above 0.0
UMBRAGE_HIGHP float umbrage_world_to_depth(UMBRAGE_HIGHP float world, UMBRAGE_HIGHP vec2 units,
                                           UMBRAGE_HIGHP float w) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = world * units.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = w * w;
    return umbrage_clamp_bias(along / square);
}
)GLSL",
};

inline constexpr const snippet* light_units_snippets[]{&texels_to_world, &world_to_depth};

}  // namespace glsl
}  // namespace umbrage
