// SPDX-License-Identifier: MIT
//
// Cube shadow map of a point light: six maps, one per face. A border lets filters stay within a face.
//
//     const umbrage::point_light<float> bulb{.position = p, .map_size = 512, .border = 2, .clip = clip};
//     umbrage::shadow lamp(bulb, {512, 512}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Place of a point of the world in a cube's six maps.
/// @param face       x: texels a unit across the face's axis, at distance 1 along it; y: middle of a map, texels; z:
///                   depth over 1 / distance; w: z / x
/// @param anchor     xyz: position of the light
/// @param rounding   of the anchored_map from a face's axes to texels of its map
/// @param slack      likewise
/// @param world      position of the point
/// @param normal     its normal
/// @return           its place on the face that it lies before, with weight 1
/// @edge             at the light: so far before the near plane that it is lit
/// @formula          as anchored_place. With w = |way| along the face's axis, place = (x (sc, tc) / w + y, z / w), and
///                   slope = w (normal's sc, tc) / (normal . way)
/// @exactness        C, n = 121: as anchored_place
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 1> cube_maps_places(
    const glm::vec4& face, const glm::vec4& anchor, const glm::vec4& rounding, const glm::vec4& slack,
    const shadow_terms&, glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 way = world - glm::vec3(anchor);
    const int number = cube_face(way);
    const glm::vec3 there = cube_face_point(float(number), way), across = cube_face_point(float(number), normal);
    const float off_plane = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    const float rise = face.w / (off_plane == 0.0f ? 1e-30f : off_plane);
    const glm::vec2 slope = glm::vec2(across) * rise;
    const float i = 1.0f / (there.z > 1e-30f ? there.z : 1e-30f), z = face.z * i;
    const glm::vec2 at = glm::vec2(there) * (face.x * i) + face.y;
    const float steep = glm::abs(slope.x) + glm::abs(slope.y), moves = rounding.x + rounding.y * i;
    const float off = glm::abs(z) * (moves + slack.y) + slack.z;  // a lens has no rounding.w
    const float all = (moves * rounding.z + slack.x) * steep + off;
    return {map_place{number, {at, z + slack.w}, slope, 1.0f, all}};
}

namespace glsl {

inline constexpr snippet cube_maps_places{
    .name = "cube_maps_places",
    .summary = "place of a point of the world in a cube's six maps",
    .exactness = tier::c,
    .operations = 121,
    .source = R"GLSL(
// umbrage_cube_maps_places: place of a point of the world in a cube's six maps
//   face              texels a unit across the face's axis, at distance 1 along it; middle of a map; depth over
//                     1.0 / distance, and that by texels
//   anchor            position of the light
//   rounding, slack   of umbrage_anchored_place, from a face's axes
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_cube_maps_places(UMBRAGE_HIGHP vec4 face, UMBRAGE_HIGHP vec4 anchor,
                                            UMBRAGE_HIGHP vec4 rounding, UMBRAGE_HIGHP vec4 slack,
                                            UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec3 world,
                                            UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec3 m = abs(way);
    bool on_x = m.x >= m.y ? m.x >= m.z : false;
    bool on_y = on_x ? false : m.y >= m.z;
    UMBRAGE_HIGHP float along = on_x ? way.x : (on_y ? way.y : way.z);
    UMBRAGE_HIGHP float flip = along < 0.0 ? -1.0 : 1.0;
    UMBRAGE_HIGHP float number = (on_x ? 0.5 : (on_y ? 2.5 : 4.5)) - 0.5 * flip;
    UMBRAGE_HIGHP vec2 signs = vec2(on_x ? -flip : (on_y ? 1.0 : flip), on_y ? flip : -1.0);
    UMBRAGE_HIGHP vec2 there = vec2(on_x ? way.z : way.x, on_y ? way.z : way.y) * signs;
    UMBRAGE_HIGHP vec2 across = vec2(on_x ? normal.z : normal.x, on_y ? normal.z : normal.y) * signs;
    UMBRAGE_HIGHP float off_plane = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_HIGHP float rise = face.w / (off_plane == 0.0 ? 1.0e-30 : off_plane);  // as umbrage_receiver_slope
    UMBRAGE_HIGHP vec2 slope = across * rise;
    UMBRAGE_HIGHP float i = 1.0 / max(abs(along), 1.0e-30);
    UMBRAGE_HIGHP float z = face.z * i;
    UMBRAGE_HIGHP vec2 at = there * (face.x * i) + face.y;
    UMBRAGE_HIGHP float steep = abs(slope.x) + abs(slope.y);
    UMBRAGE_HIGHP float moves = rounding.x + rounding.y * i;
    UMBRAGE_HIGHP float off = abs(z) * (moves + slack.y) + slack.z;  // a lens has no rounding.w
    UMBRAGE_HIGHP float all = (moves * rounding.z + slack.x) * steep + off;
    return mat4(vec4(at, z + slack.w, number), vec4(slope, 1.0, all), none, none);
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

    struct uniforms {
        glm::vec4 face;             ///< of cube_maps_places
        glm::vec4 anchor{0};        ///< xyz: position of the light
        glm::vec4 rounding, slack;  ///< those of the anchored_map from a face's axes to texels of its map
    };
    static constexpr uniform_field fields[]{{"face", false}, {"anchor", false}, {"rounding", false}, {"slack", false}};
    static constexpr map_grid grid{3, 2};
    static constexpr outside_map outside = outside_map::clamped;

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        const auto faces = make_point_light(light);
        return {faces.begin(), faces.end()};
    }
    /// @throws std::invalid_argument  a filter's reach above the border
    void require_reach(float reach) const { detail::require_reach("shadow", "light.border", light.border, reach); }
    /// @throws std::invalid_argument  a map_size other than the light's; a near plane whose depths underflow
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
        const anchored_map of = detail::anchored_axes(m, map_size, light.clip, light.position - origin);
        const float texels = of.to_texels[0][0], over = of.to_texels[3][2];
        detail::require(std::abs(over / texels) >= 0x1p-126f, "shadow", "light.z_near",
                        "far enough for depths in float", light.z_near);
        return {{texels, of.to_texels[2][0], over, over / texels}, of.anchor, of.rounding, of.slack};
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 1> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return cube_maps_places(u.face, u.anchor, u.rounding, u.slack, terms, world, normal);
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
