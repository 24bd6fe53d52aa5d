// SPDX-License-Identifier: MIT
//
// Cube shadow map of a point light: six maps, one per face. A border lets filters stay within a face.
//
//     const umbrage::point_light<float> bulb{.position = p, .map_size = 512, .border = 3, .clip = clip};
//     umbrage::shadow lamp(bulb, {512, 512}, umbrage::filters::tent<3>);
//
#pragma once

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

/// Setup of a cube's six maps.
struct cube_maps {
    point_light<double> light;

    template <real T>
    explicit cube_maps(const point_light<T>& l)
        : light{glm::dvec3(l.position), double(l.z_near), double(l.z_far), l.map_size, l.border, l.clip} {
        static_cast<void>(make_point_light(light));  // checks the light
    }

    struct uniforms {
        glm::vec4 position;   ///< position of the light; w: 0
        glm::mat4 to_texels;  ///< matrix from a face's axes (cube_face_point) to texels of its map
        glm::mat4 planes;     ///< plane_matrix of to_texels
    };
    static constexpr uniform_field fields[]{{"position", false}, {"to_texels"}, {"planes"}};
    static constexpr map_grid grid{3, 2};
    static constexpr outside_map outside = outside_map::clamped;
    static constexpr glsl::map_choice tiles{true, glsl::cube_tile.name};

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        const auto faces = make_point_light(light);
        return {faces.begin(), faces.end()};
    }
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
        return {glm::vec4(light.position - origin, 0.0), glm::mat4(m), glm::mat4(plane_matrix(m))};
    }

    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms&, glm::vec3 world, glm::vec3 normal,
                                          const Look& look) {
        const glm::vec3 way = world - glm::vec3(u.position);
        const int face = cube_face(way);
        const glm::vec3 there = cube_face_point(float(face), way), across = cube_face_point(float(face), normal);
        const glm::vec3 at = project_coordinate(shadow_coordinate(u.to_texels, there));
        return look(map_place{face, at, receiver_slope(u.planes, across, there)});
    }
    [[nodiscard]] static std::string text(const glsl::map_choice& choice) {
        return R"GLSL(
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP float face = umbrage_cube_face(way);
    UMBRAGE_HIGHP vec3 there = umbrage_cube_face_point(face, way);
    UMBRAGE_HIGHP vec3 across = umbrage_cube_face_point(face, normal);
    UMBRAGE_HIGHP vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
)GLSL" + choice.first("face") +
               "    return umbrage_look(map, terms, filter_terms, at, umbrage_receiver_slope(planes, across, "
               "there));\n";
    }
    static constexpr const auto& needs = glsl::list<&glsl::cube_face, &glsl::cube_face_point, &glsl::project_coordinate,
                                                    &glsl::shadow_coordinate, &glsl::receiver_slope, &glsl::cube_tile>;
};

/// Setup of a point light.
template <real T>
struct set_up_for<point_light<T>> {
    using type = cube_maps;
};

}  // namespace umbrage
