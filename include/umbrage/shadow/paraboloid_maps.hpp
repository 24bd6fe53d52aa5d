// SPDX-License-Identifier: MIT
//
// Dual paraboloid shadow maps of a point light: two maps, each with a paraboloid's image of half of all directions.
// They need two passes where a cube map needs six, and a mesh of short edges. They store distances, not depths.
//
//     const umbrage::dual_paraboloid_light<float> bulb{.position = p, .range = 30, .border = 2, .clip = clip};
//     umbrage::shadow lamp(bulb, {512, 512}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <span>
#include <vector>

#include <umbrage/bias/distance_slope.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/draw/dual_paraboloid_pass.hpp>
#include <umbrage/draw/tessellate.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Place of a point of the world in two paraboloid maps.
/// @param position        position of the light; w: depth per world unit
/// @param halves          x: size of a paraboloid's image in texels; y: border; z: slope of a depth per texel; w: depth
///                        at the light
/// @param rounding        x: error of a depth by rounding
/// @param world           position of the point
/// @param normal          its normal
/// @return                its place, with weight 1
/// @exactness             C, n = 57: as dual_paraboloid_coordinate, distance_depth and dual_paraboloid_slope. S of each
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 1> paraboloid_maps_places(const glm::vec4& position,
                                                                                    const glm::vec4& halves,
                                                                                    const glm::vec4& rounding,
                                                                                    const shadow_terms&,
                                                                                    glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 way = world - glm::vec3(position), found = dual_paraboloid_coordinate(way);
    const glm::vec2 at = glm::vec2(found) * halves.x + halves.y;
    const float depth = distance_depth(way, position.w) + halves.w;
    return {
        map_place{int(found.z), glm::vec3(at, depth), dual_paraboloid_slope(way, normal, halves.z), 1.0f, rounding.x}};
}

/// Vertex of the depth pass of a paraboloid map, in clip space. Lines between vertices stay straight there.
/// @param to_clip    the light's projection
/// @param world      position of the vertex
/// @param anchor     xyz: position of the light
/// @param number     0 or 1: the map
/// @exactness        C, n = 51: as dual_paraboloid_position, then the matrix' sums
[[nodiscard]] inline glm::vec4 paraboloid_vertex(const glm::mat4& to_clip, glm::vec3 world, const glm::vec4& anchor,
                                                 float number) {
    const glm::vec4 p = dual_paraboloid_position(world - glm::vec3(anchor), number);
    return to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
}

namespace glsl {

inline constexpr snippet paraboloid_maps_places{
    .name = "paraboloid_maps_places",
    .summary = "place of a point of the world in two paraboloid maps",
    .exactness = tier::c,
    .operations = 57,
    .needs = list<&dual_paraboloid_coordinate, &distance_depth, &dual_paraboloid_slope>,
    .source = R"GLSL(
// umbrage_paraboloid_maps_places: place of a point of the world in two paraboloid maps
//   position   position of the light, and depth per world unit
//   halves     size of a paraboloid's image and its border in texels, slope of a depth per texel, depth at the light
//   rounding   error of a depth by rounding
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_paraboloid_maps_places(UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP vec4 halves,
                                                  UMBRAGE_HIGHP vec4 rounding, UMBRAGE_HIGHP vec4 terms,
                                                  UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP vec3 found = umbrage_dual_paraboloid_coordinate(way);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 at = vec2(found.x, found.y) * halves.x + halves.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = umbrage_distance_depth(way, position.w) + halves.w;
    UMBRAGE_HIGHP vec2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    return mat4(vec4(at, depth, found.z), vec4(slope, 1.0, rounding.x), none, none);
}
)GLSL",
};

inline constexpr snippet paraboloid_vertex{
    .name = "paraboloid_vertex",
    .summary = "clip space position of a vertex in a paraboloid map",
    .exactness = tier::c,
    .operations = 51,
    .needs = list<&dual_paraboloid_position>,
    .source = R"GLSL(
// umbrage_paraboloid_vertex: clip space position of a vertex in a paraboloid map
//   to_clip    the light's projection
//   anchor     position of the light
//   number     0.0 or 1.0, the map
UMBRAGE_HIGHP vec4 umbrage_paraboloid_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world,
                                             UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP float number) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 p = umbrage_dual_paraboloid_position(way, number);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 place =
        to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
    return place;
}
)GLSL",
};

inline constexpr const snippet* paraboloid_maps_snippets[]{&paraboloid_maps_places, &paraboloid_vertex};

}  // namespace glsl

/// Setup of two paraboloid maps.
struct paraboloid_maps {
    dual_paraboloid_light<double> light;

    template <real T>
    explicit paraboloid_maps(const dual_paraboloid_light<T>& l)
        : light{glm::dvec3(l.position), double(l.range), l.map_size, l.border, l.clip} {
        static_cast<void>(make_dual_paraboloid_light(light));  // checks the light
    }

    struct uniforms {
        glm::vec4 position;  ///< position of the light; w: depth per world unit, 1 / range, or reversed -1 / range
        glm::vec4 halves;    ///< x: map_size - 2 border; y: border; z: 2 / (range x); w: depth at the light
        glm::vec4 rounding;  ///< x: error of a depth by rounding
    };
    static constexpr uniform_field fields[]{{"position", false}, {"halves", false}, {"rounding", false}};
    static constexpr map_grid grid{2, 1};
    static constexpr outside_map outside = outside_map::clamped;
    static constexpr float depth_error = 1.0f / 4096.0f;  ///< of tessellated meshes

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const { return {2, make_dual_paraboloid_light(light)}; }
    template <class ParallelFor>
    void draw(image_view<float> depths, const mesh_view& mesh, std::span<const glm::mat4> instances, glm::dvec3 origin,
              ParallelFor&& parallel) const {
        auto here = light;  // of positions less its own: there the cuts of edges round least
        here.position = glm::dvec3(0);
        const glm::dvec3 from = light.position - origin;
        const light_space<double> space = make_dual_paraboloid_light(here);
        const light_space<float> single{glm::mat4(space.view), glm::mat4(space.projection), space.clip};
        const tessellation to{.angle = float(paraboloid_edge_angle(light.map_size, light.border)),
                              .range = float(light.range),
                              .depth_error = depth_error};
        const glm::ivec2 size(light.map_size);
        std::vector<glm::vec3> placed;
        for (const glm::mat4& model : instances) {
            placed.clear();
            for (const glm::vec3& p : mesh.positions)
                placed.emplace_back(glm::dvec3(glm::dmat4(model) * glm::dvec4(p, 1)) - from);
            const auto cut = tessellate({placed, mesh.triangles}, to);
            for (const int map : {0, 1})
                rasterize_dual_paraboloid(depths.region({map * size.x, 0}, size), cut.view(), single, map, parallel);
        }
    }
    /// Depth by which a plane leaves its slope's straight line over some texels: distances along it grow as a secant.
    [[nodiscard]] static float bend(const uniforms& u, const shadow_terms& terms, glm::vec3 world, glm::vec3 normal) {
        const glm::dvec3 way(world - glm::vec3(u.position)), n(normal);
        const double away = glm::length(way), depth = away * std::abs(double(u.position.w));
        const bool turned = normal != glm::vec3(0);
        const double facing = turned ? std::abs(glm::dot(n, way)) / (glm::length(n) * away) : 1.0;
        // Radians of the diagonal of the reach: a texel has 2 (1 + |z|) of them over a map, and z turns with them.
        const double most = std::sqrt(32.0) * double(terms.reach) / double(u.halves.x);
        const double angle = most * (0.5 + 0.5 * (glm::min)(1.0, std::abs(way.z) / away + most));
        const double tilt = std::acos((glm::min)(facing, 1.0));
        if (!(tilt + angle < 1.5)) return 1.0f;
        return float(depth * (facing / std::cos(tilt + angle) - 1.0 - angle * std::tan(tilt)));
    }
    /// @throws std::invalid_argument  a filter's reach above the border
    void require_reach(float reach) const { detail::require_reach("shadow", "light.border", light.border, reach); }
    /// @throws std::invalid_argument  a map_size other than the light's; an origin farther than 2048 times its range
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        detail::require_size(map_size, glm::ivec2(light.map_size), "shadow", "map_size", "the paraboloid light's");
        const double inner = light.map_size - 2 * light.border, away = glm::length(light.position - origin);
        detail::require_digits(away, light.range);
        const bool forward = light.clip.direction == depth_direction::forward;
        return {glm::vec4(glm::dvec4(light.position - origin, (forward ? 1.0 : -1.0) / light.range)),
                glm::vec4(glm::dvec4(inner, light.border, 2.0 / (light.range * inner), forward ? 0.0 : 1.0)),
                glm::vec4(detail::one_rounding * (12.0 + 3.0 * away / light.range), 0, 0, 0)};
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 1> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return paraboloid_maps_places(u.position, u.halves, u.rounding, terms, world, normal);
    }
    static constexpr const glsl::snippet* placing = &glsl::paraboloid_maps_places;
};

/// Vertex function of paraboloid maps.
inline constexpr vertex_function paraboloid_vertices{&glsl::paraboloid_vertex, {{{"anchor", 4}, {"number", 1}}}};
/// Errors of lines that paraboloids bend, and the vertex function that bends them.
template <>
inline constexpr bent_lines bends_of<paraboloid_maps>{tessellation_reach<float>, paraboloid_maps::depth_error,
                                                      &paraboloid_vertices};

/// Setup of a light with paraboloid maps.
template <real T>
struct setup_for<dual_paraboloid_light<T>> {
    using type = paraboloid_maps;
};

}  // namespace umbrage
