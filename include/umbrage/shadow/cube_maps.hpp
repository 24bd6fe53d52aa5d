// SPDX-License-Identifier: MIT
//
// Cube shadow map of a point light: six maps, one per face. A border lets filters stay within a face.
//
//     const umbrage::point_light<float> bulb{.position = p, .map_size = 512, .border = 2, .clip = clip};
//     umbrage::shadow lamp(bulb, {512, 512}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/shadow/single_map.hpp>

namespace umbrage {

/// Place of a point of the world in a cube's six maps.
/// @param to_texels                             anchored_map from a face's axes to texels of its map; the anchor is the
///                                              light
/// @param planes                                likewise
/// @param anchor                                likewise
/// @param rounding                              likewise
/// @param slack                                 likewise
/// @param world                                 position of the point
/// @param normal                                its normal
/// @return                                      its place on the face that it lies before, with weight 1
/// @exactness                                   C, n = 121: as anchored_place
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 1> cube_maps_places(
    const glm::mat4& to_texels, const glm::mat4& planes, const glm::vec4& anchor, const glm::vec4& rounding,
    const glm::vec4& slack, const shadow_terms&, glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 way = world - glm::vec3(anchor);
    const int face = cube_face(way);
    const glm::vec3 there = cube_face_point(float(face), way), across = cube_face_point(float(face), normal);
    map_place place = anchored_place(to_texels, planes, rounding, slack, there, across);
    place.number = face;
    return {place};
}

namespace glsl {

inline constexpr snippet cube_maps_places{
    .name = "cube_maps_places",
    .summary = "place of a point of the world in a cube's six maps",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&cube_face, &cube_face_point, &anchored_place>,
    .source = R"GLSL(
// umbrage_cube_maps_places: place of a point of the world in a cube's six maps
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, from a face's axes
//   anchor                               position of the light
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_cube_maps_places(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                            UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 rounding,
                                            UMBRAGE_HIGHP vec4 slack, UMBRAGE_HIGHP vec4 terms,
                                            UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP float face = umbrage_cube_face(way);
    UMBRAGE_HIGHP mat4 place =
        umbrage_anchored_place(to_texels, planes, rounding, slack, umbrage_cube_face_point(face, way),
                               umbrage_cube_face_point(face, normal));
    return mat4(vec4(place[0].x, place[0].y, place[0].z, face), place[1], place[2], place[3]);
}
)GLSL",
};

inline constexpr const snippet* cube_maps_snippets[]{&cube_maps_places};

}  // namespace glsl

/// Setup of a cube's six maps.
struct cube_maps {
    point_light<double> light;

    template <real T>
    explicit cube_maps(const point_light<T>& l)
        : light{glm::dvec3(l.position), double(l.z_near), double(l.z_far), l.map_size, l.border, l.clip} {
        static_cast<void>(make_point_light(light));  // checks the light
    }

    using uniforms = anchored_map;  ///< from a face's axes (cube_face_point) to texels of its map
    static constexpr const auto& fields = single_map::fields;
    static constexpr map_grid grid{3, 2};
    static constexpr outside_map outside = outside_map::clamped;

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        const auto faces = make_point_light(light);
        return {faces.begin(), faces.end()};
    }
    /// @throws std::invalid_argument  a filter's reach above the border
    void require_reach(float reach) const { detail::require_reach("shadow", "light.border", light.border, reach); }
    /// @throws std::invalid_argument  a map_size other than the light's
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        detail::require_size(map_size, glm::ivec2(light.map_size), "shadow", "map_size", "the point light's");
        const glm::dmat4 projection = make_point_light(light)[0].projection;
        const double half = 0.5 * light.map_size, inner = half - light.border;
        const double along = light.clip.hand == handedness::right ? -1.0 : 1.0;  // sign of view z in front of a face
        glm::dvec2 depth(along * projection[2][2], projection[3][2]);            // depth w = x w + y
        if (light.clip.range == depth_range::minus_one_to_one) depth = {0.5 * depth.x + 0.5, 0.5 * depth.y};
        glm::dmat4 m(0);
        m[0][0] = m[1][1] = inner;
        m[2] = {half, half, depth.x, 1.0};
        m[3][2] = depth.y;
        return detail::anchored_axes(m, map_size, light.clip, light.position - origin);
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 1> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return cube_maps_places(u.to_texels, u.planes, u.anchor, u.rounding, u.slack, terms, world, normal);
    }
    static constexpr const glsl::snippet* placing = &glsl::cube_maps_places;
};

/// A cube's maps are alike.
template <>
inline constexpr bool has_like_maps<cube_maps> = true;

/// Setup of a point light.
template <real T>
struct setup_for<point_light<T>> {
    using type = cube_maps;
};

}  // namespace umbrage
