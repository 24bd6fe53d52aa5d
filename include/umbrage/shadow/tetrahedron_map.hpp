// SPDX-License-Identifier: MIT
//
// Tetrahedron shadow map of a point light: four views in one square map. A cube map needs six views, and its texels
// vary less in size.
//
//     const umbrage::tetrahedron_light<float> bulb{.position = p, .map_size = 1024, .border = 2, .clip = clip};
//     umbrage::shadow lamp(bulb, {1024, 1024}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/draw/tetrahedron_pass.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/light/point/tetrahedron.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Place of a point of the world in a tetrahedron's map.
/// @param to_texels                             anchored_map from a face's axes to texels of face 0, relative to the
///                                              map's center; the anchor is the light
/// @param planes                                likewise
/// @param anchor                                likewise
/// @param rounding                              likewise
/// @param slack                                 likewise
/// @param center                                x: half the map's size, texels
/// @param world                                 position of the point
/// @param normal                                its normal
/// @return                                      its place, with weight 1
/// @exactness                                   C, n = 121: as anchored_place. S of each, and half the map's size
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 1> tetrahedron_map_places(
    const glm::mat4& to_texels, const glm::mat4& planes, const glm::vec4& anchor, const glm::vec4& rounding,
    const glm::vec4& slack, const glm::vec4& center, const shadow_terms&, glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 way = world - glm::vec3(anchor);
    const int face = tetrahedron_face(way);
    const glm::vec3 there = tetrahedron_face_point(face, way), across = tetrahedron_face_point(face, normal);
    map_place place = anchored_place(to_texels, planes, rounding, slack, there, across);
    place.at = glm::vec3(tetrahedron_turned(face, glm::vec2(place.at)) + center.x, place.at.z);
    place.slope = tetrahedron_turned(face, place.slope);
    return {place};
}

/// Shape of penumbras at a texel of a tetrahedron's map. A face's triangle is stretched in the map, so texels are not
/// square. On the left and right it lies on its side.
/// @param center   x: half the map's size, texels
/// @param at       place in the map, texels
/// @return         factors of face 0's softness in x and in y, and no shear: (1, 1, 0), or (1 / sqrt(3), sqrt(3), 0) on
///                 the left and right
/// @exactness      A: differences and comparisons
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_shape(const glm::vec<4, T>& center, T, glm::vec<2, T> at) {
    const bool beside = glm::abs(at.x - center.x) > glm::abs(at.y - center.x);
    return beside ? glm::vec<3, T>(T(0.577350269f), T(1.73205081f), T(0)) : glm::vec<3, T>(T(1), T(1), T(0));
}

namespace glsl {

inline constexpr snippet tetrahedron_shape{
    .name = "tetrahedron_shape",
    .summary = "shape of penumbras at a texel of a tetrahedron's map",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_tetrahedron_shape: shape of penumbras at a texel of a tetrahedron's map
//   center   x: half the map's size in texels
//   number   not read
//   at       place in the map, texels
//   returns factors of face 0's softness in x and y, and no shear
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_shape(UMBRAGE_HIGHP vec4 center, UMBRAGE_HIGHP float number,
                                             UMBRAGE_HIGHP vec2 at) {
    bool beside = abs(at.x - center.x) > abs(at.y - center.x);
    return beside ? vec3(0.577350269, 1.73205081, 0.0) : vec3(1.0, 1.0, 0.0);
}
)GLSL",
};

inline constexpr snippet tetrahedron_map_places{
    .name = "tetrahedron_map_places",
    .summary = "place of a point of the world in a tetrahedron's map",
    .exactness = tier::c,
    .operations = 121,
    .needs = list<&tetrahedron_face, &tetrahedron_face_point, &tetrahedron_turned, &anchored_place>,
    .source = R"GLSL(
// umbrage_tetrahedron_map_places: place of a point of the world in a tetrahedron's map
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, from a face's axes to texels of face 0, relative
//                                        to the center
//   anchor                               position of the light
//   center                               half the map's size in texels
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_tetrahedron_map_places(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                                  UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 rounding,
                                                  UMBRAGE_HIGHP vec4 slack, UMBRAGE_HIGHP vec4 center,
                                                  UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec3 world,
                                                  UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP float face = umbrage_tetrahedron_face(way);
    UMBRAGE_HIGHP mat4 place =
        umbrage_anchored_place(to_texels, planes, rounding, slack, umbrage_tetrahedron_face_point(face, way),
                               umbrage_tetrahedron_face_point(face, normal));
    UMBRAGE_HIGHP vec2 at = umbrage_tetrahedron_turned(face, vec2(place[0].x, place[0].y)) + center.x;
    UMBRAGE_HIGHP vec2 slope = umbrage_tetrahedron_turned(face, vec2(place[1].x, place[1].y));
    return mat4(vec4(at, place[0].z, 0.0), vec4(slope, place[1].z, place[1].w), place[2], place[3]);
}
)GLSL",
};

inline constexpr const snippet* tetrahedron_map_snippets[]{&tetrahedron_map_places, &tetrahedron_shape};

}  // namespace glsl

/// Setup of a tetrahedron's four views.
struct tetrahedron_map {
    tetrahedron_light<double> light;

    template <real T>
    explicit tetrahedron_map(const tetrahedron_light<T>& l)
        : light{glm::dvec3(l.position), double(l.z_near), double(l.z_far), l.map_size, l.border, l.clip} {
        static_cast<void>(make_tetrahedron_light(light));  // checks the light
    }

    struct uniforms : anchored_map {  ///< from a face's axes (tetrahedron_face_point) to texels of face 0's triangle,
                                      ///< relative to the map's center
        glm::vec4 center;             ///< x: half the map's size, texels
    };
    static constexpr uniform_field fields[]{{"to_texels"},       {"planes"},       {"anchor", false},
                                            {"rounding", false}, {"slack", false}, {"center", false}};
    static constexpr map_grid grid{};
    static constexpr outside_map outside = outside_map::clamped;

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        const auto faces = make_tetrahedron_light(light);
        return {faces.begin(), faces.end()};
    }
    template <class ParallelFor>
    void draw(image_view<float> depths, const mesh_view& mesh, std::span<const glm::mat4> instances, glm::dvec3 origin,
              ParallelFor&& parallel) const {
        auto here = light;
        here.position -= origin;
        rasterize_tetrahedron(depths, mesh, instances, make_tetrahedron_light(here), cull_mode::none, parallel);
    }
    /// @throws std::invalid_argument  a filter's reach above the border
    void require_reach(float reach) const { detail::require_reach("shadow", "light.border", light.border, reach); }
    /// @throws std::invalid_argument  map_size other than the light's
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        detail::require_size(map_size, glm::ivec2(light.map_size), "shadow", "map_size", "the tetrahedron light's");
        const glm::dmat4 projection = make_tetrahedron_light(light)[0].projection;
        const double half = 0.5 * light.map_size, scale = half - 3.0 * light.border, base = light.border - half;
        const double up = -std::sqrt(1.0 / 3.0), away = std::sqrt(2.0 / 3.0);    // components of the face's normal
        const double along = light.clip.hand == handedness::right ? -1.0 : 1.0;  // sign of view z in front of a face
        glm::dvec2 depth(along * projection[2][2], projection[3][2]);            // depth w = x w + y
        if (light.clip.range == depth_range::minus_one_to_one) depth = {0.5 * depth.x + 0.5, 0.5 * depth.y};
        const double side =
            scale / std::sqrt(6.0);  // (aside, away) / (2 away - sqrt(2) up), the divisor being sqrt(6) w
        glm::dmat4 m(0);
        m[0][0] = side;
        m[1] = {0.0, base * up, depth.x * up, up};
        m[2] = {0.0, side + base * away, depth.x * away, away};
        m[3][2] = depth.y;
        return {detail::anchored_axes(m, map_size, light.clip, light.position - origin), glm::vec4(half, 0, 0, 0)};
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 1> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return tetrahedron_map_places(u.to_texels, u.planes, u.anchor, u.rounding, u.slack, u.center, terms, world,
                                      normal);
    }
    static constexpr const glsl::snippet* placing = &glsl::tetrahedron_map_places;
    [[nodiscard]] static glm::vec3 shape(const uniforms& u, float number, glm::vec2 at) {
        return tetrahedron_shape(u.center, number, at);
    }
    static constexpr shape_function shaping{&glsl::tetrahedron_shape, "center"};
};

/// Setup of a light with the map of a tetrahedron.
template <real T>
struct setup_for<tetrahedron_light<T>> {
    using type = tetrahedron_map;
};

}  // namespace umbrage
