// SPDX-License-Identifier: MIT
//
// Dual paraboloid shadow maps: two square maps around a point light, each a paraboloid's image of half of all
// directions. Depth is the distance from the light. Straight edges become arcs, so draw a mesh cut by tessellate.
//
//     auto light = umbrage::make_dual_paraboloid_light<float>({.position = p, .range = 30, .border = 2, .clip = clip});
//     auto cut = umbrage::tessellate(mesh, {p, umbrage::paraboloid_edge_angle(512, 2), 30});
//     for (int map : {0, 1}) umbrage::rasterize_dual_paraboloid(maps[map].view(), cut.view(), light, map);
//
//     glm::vec3 at = umbrage::dual_paraboloid_coordinate(world - p);  // (s, t, map)
//     glm::vec2 texel = glm::vec2(at) * float(512 - 2 * 2) + 2.0f;    // in maps[int(at.z)]
//     float depth = umbrage::distance_depth(world - p, 1.0f / 30.0f);
//
// In a vertex shader set gl_Position to `projection * umbrage_dual_paraboloid_position(world - p, map)`, for the cut
// mesh. Vertices behind the map need a clip distance, such as position.w - 0.1 * distance.
//
// `plane_slope` does not hold for distances. bias/distance_slope.hpp has their slope, and the reach that tessellation
// adds.
//
// A border of texels extends each map beyond its half, so that filters need no other map: see point_light.hpp.
// Also called: paraboloid shadow maps, DPSM (make_dual_paraboloid_light, dual_paraboloid_coordinate).
// See also: cube_map.hpp, tetrahedron.hpp.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Point light with two paraboloid maps.
template <real T = float>
struct dual_paraboloid_light {
    glm::vec<3, T> position{T(0)};
    T range = T(100);    ///< largest distance from the light with a depth, world units, > 0
    int map_size = 512;  ///< size of each map, in texels, >= 16
    int border = 2;      ///< texels around the half's circle, inside map_size, at most 1/8 of it: the filter's reach or
                         ///< more. 2 is enough for tent<3>
    clip_space clip{};   ///< required: clip space of your API or engine, see clip_space.hpp
};

/// Map that sees a direction, and the position in it.
///
/// Map 0 holds +z, and map 1 holds -z. Each is oriented as a right-handed view along that axis with y up. Beyond its
/// circle a map continues in the other one, at 1 - s and the same t.
/// @param direction   vector from the light, of length 1e-18 to 1e18
/// @return            (s, t, map): s and t from 0 to 1 over the map's square, inside its circle; map 0 or 1
/// @edge              zero or NaN: NaN coordinates, which every filter takes as lit
/// @formula           s = 1/2 + -x / 2 (|p| + |z|), for z < 0 with x, t = 1/2 + y / 2 (|p| + |z|). A texel is as wide
///                    as it is high: 2 (1 + |z| / |p|) / map_size radians, at the center twice its size at the rim
/// @exactness         C, n = 32: a square root and divisions
/// @cite              Brabec, Annen, Seidel: Shadow Mapping for Hemispherical and Omnidirectional Light Sources, 2002
template <real T>
[[nodiscard]] glm::vec<3, T> dual_paraboloid_coordinate(glm::vec<3, T> direction) {
    const T square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    const bool behind = direction.z < T(0);
    const T m = std::sqrt(square) + (behind ? -direction.z : direction.z);
    return {((behind ? direction.x : -direction.x) + m) / (m + m), (direction.y + m) / (m + m), T(behind ? 1 : 0)};
}

/// Position of a vertex in the depth pass, before the projection of make_dual_paraboloid_light.
/// @param direction   vector from the light to the vertex
/// @param map         index of the map, 0 or 1
/// @return            (x w, y w, distance w, w). x and y are from -1 to 1 in the map's half, and larger beyond it. w is
///                    never below 0, and is 0 at the center of the other half
/// @formula           w = |p| + z, for map 1 |p| - z
/// @exactness         C, n = 18: a square root. S(w) = |p| + |z|, S(z) = |p| S(w). x and y are exact
template <real T>
[[nodiscard]] glm::vec<4, T> dual_paraboloid_position(glm::vec<3, T> direction, T map) {
    const bool behind = map > T(0.5);
    const T length = std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
    const T w = length + (behind ? -direction.z : direction.z);
    return {behind ? direction.x : -direction.x, direction.y, length * w, w};
}

/// Light space for the depth passes of both maps: a translation to the light, and a projection for
/// dual_paraboloid_position.
///
/// The first texel is at (0, 0) of dual_paraboloid_coordinate in every clip space. Depth is distance_depth, or 1 minus
/// it. The projection is a mirror if clip is either left-handed or has its first row at the top, but not both.
/// @throws std::invalid_argument  too few texels; too wide a border; range not above 0; clip unset; matrices that would
///                                not be finite
template <real T = float>
[[nodiscard]] light_space<T> make_dual_paraboloid_light(const dual_paraboloid_light<T>& light) {
    constexpr auto function = "make_dual_paraboloid_light";
    detail::require(light.map_size >= 16, function, "map_size", "16 or more", light.map_size);
    detail::require(light.border >= 0 && light.border <= light.map_size / 8, function, "border",
                    "from 0 to an eighth of map_size", light.border);
    detail::require_given(light.clip, function);
    detail::require(detail::all_finite(light.position), function, "position", "finite", light.position);
    const bool in_range = light.range > T(0) && detail::is_normal(light.range) && detail::is_normal(T(1) / light.range);
    detail::require(in_range, function, "range", "above 0, and it and 1 / range finite", light.range);
    const auto [at_light, at_range] = detail::ends<T>(light.clip);
    light_space<T> space{.clip = light.clip};
    space.view[3] = glm::vec<4, T>(-light.position, T(1));
    space.projection = glm::mat<4, 4, T>(T(0));
    space.projection[0][0] = T(light.map_size - 2 * light.border) / T(light.map_size);
    space.projection[1][1] =
        light.clip.origin == texture_origin::bottom ? space.projection[0][0] : -space.projection[0][0];
    space.projection[2][2] = (at_range - at_light) / light.range;
    space.projection[3][2] = at_light;
    space.projection[3][3] = T(1);
    return detail::checked<T>(space, function, "position and range");
}

/// Largest angle that a straight edge may have, seen from the light, to be drawn within half a texel of its true place.
/// It holds inside the circle and a border around it, also where a square kernel's corner reaches beyond in a diagonal.
/// @param map_size           as make_dual_paraboloid_light takes it
/// @param border             as make_dual_paraboloid_light takes it
/// @return                   angle from end to end, radians
/// @edge                     map_size of 2 border or less, which no light has: NaN
/// @formula                  2 sqrt(2 / n) 2 / (1 + r^2), n = map_size - 2 border, r = 1 + 2 sqrt(2) border / n.
///                           Over the chord of an angle a, arcs are up to n / 16 (a (1 + r^2) / 2)^2 texels high, at r
///                           circles out
template <real T = float>
[[nodiscard]] T paraboloid_edge_angle(int map_size, int border = dual_paraboloid_light<T>{}.border) {
    const T inner = T(map_size - 2 * border), rim = T(1) + T(2) * std::sqrt(T(2)) * T(border) / inner;
    return T(2) * std::sqrt(T(2) / inner) * (T(2) / (T(1) + rim * rim));
}

namespace glsl {

inline constexpr snippet dual_paraboloid_coordinate{
    .name = "dual_paraboloid_coordinate",
    .summary = "paraboloid map that sees a direction, and position in it",
    .exactness = tier::c,
    .operations = 32,
    .source = R"GLSL(
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
UMBRAGE_HIGHP vec3 umbrage_dual_paraboloid_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    UMBRAGE_HIGHP float m = sqrt(square) + (behind ? -direction.z : direction.z);
    UMBRAGE_HIGHP float x = behind ? direction.x : -direction.x;
    return vec3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
)GLSL",
};

inline constexpr snippet dual_paraboloid_position{
    .name = "dual_paraboloid_position",
    .summary = "position of a vertex in a paraboloid map's depth pass",
    .exactness = tier::c,
    .operations = 18,
    .source = R"GLSL(
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex
//   map        index of the map, 0.0 or 1.0
UMBRAGE_HIGHP vec4 umbrage_dual_paraboloid_position(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP float map) {
    bool behind = map > 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    UMBRAGE_HIGHP float distance_to = sqrt(square);
    UMBRAGE_HIGHP float w = distance_to + (behind ? -direction.z : direction.z);
    return vec4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
)GLSL",
};

inline constexpr const snippet* dual_paraboloid_snippets[]{&dual_paraboloid_coordinate, &dual_paraboloid_position};

}  // namespace glsl
}  // namespace umbrage
