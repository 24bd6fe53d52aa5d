// SPDX-License-Identifier: MIT
//
// Tetrahedron shadow map of a point light: four views in one square map. A cube map needs six views, and its texels
// vary less in size.
//
//     const umbrage::tetrahedron_light<float> bulb{.position = p, .map_size = 1024, .border = 3, .clip = clip};
//     umbrage::shadow lamp(bulb, {1024, 1024}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/images/tetrahedron_pass.hpp>
#include <umbrage/light/point/tetrahedron.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

/// Setup of a tetrahedron's four views.
struct tetrahedron_map {
    tetrahedron_light<double> light;

    template <real T>
    explicit tetrahedron_map(const tetrahedron_light<T>& l)
        : light{glm::dvec3(l.position), double(l.z_near), double(l.z_far), l.map_size, l.border, l.clip} {
        static_cast<void>(make_tetrahedron_light(light));  // checks the light
    }

    struct uniforms {
        glm::vec4 position;   ///< position of the light; w: half the map's size, texels
        glm::mat4 to_texels;  ///< matrix from a face's axes (tetrahedron_face_point) to texels of face 0's triangle,
                              ///< relative to the map's center
        glm::mat4 planes;     ///< plane_matrix of to_texels
    };
    static constexpr uniform_field fields[]{{"position", false}, {"to_texels"}, {"planes"}};
    static constexpr map_grid grid{};
    static constexpr outside_map outside = outside_map::clamped;
    static constexpr glsl::map_choice tiles{};

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        const auto faces = make_tetrahedron_light(light);
        return {faces.begin(), faces.end()};
    }
    template <class ParallelFor>
    void draw(image_view<float> depths, const mesh_view& mesh, ParallelFor&& parallel) const {
        std::array<light_space<float>, 4> faces;
        const auto all = lights();
        for (std::size_t i = 0; i < 4; ++i)
            faces[i] = {glm::mat4(all[i].view), glm::mat4(all[i].projection), all[i].clip};
        rasterize_tetrahedron(depths, mesh, faces, cull_mode::none, parallel);
    }
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
        return {glm::vec4(glm::dvec4(light.position - origin, half)), glm::mat4(m), glm::mat4(plane_matrix(m))};
    }

    [[nodiscard]] static map_place place(const uniforms& u, glm::vec3 world, glm::vec3 normal) {
        const glm::vec3 way = world - glm::vec3(u.position);
        const int face = tetrahedron_face(way);
        const glm::vec3 there = tetrahedron_face_point(face, way), across = tetrahedron_face_point(face, normal);
        const glm::vec3 on_first = project_coordinate(shadow_coordinate(u.to_texels, there));
        const glm::vec2 at = tetrahedron_turned(face, glm::vec2(on_first)) + u.position.w;
        return {0, glm::vec3(at, on_first.z), tetrahedron_turned(face, receiver_slope(u.planes, across, there))};
    }
    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms&, glm::vec3 world, glm::vec3 normal,
                                          const Look& look) {
        return look(place(u, world, normal));
    }
    [[nodiscard]] static std::string text(const glsl::map_choice&) {
        return R"GLSL(
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP float face = umbrage_tetrahedron_face(way);
    UMBRAGE_HIGHP vec3 there = umbrage_tetrahedron_face_point(face, way);
    UMBRAGE_HIGHP vec3 across = umbrage_tetrahedron_face_point(face, normal);
    UMBRAGE_HIGHP vec3 on_first = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    UMBRAGE_HIGHP vec2 at = umbrage_tetrahedron_turned(face, vec2(on_first.x, on_first.y)) + position.w;
    UMBRAGE_HIGHP vec2 slope = umbrage_tetrahedron_turned(face, umbrage_receiver_slope(planes, across, there));
    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, on_first.z), slope);
)GLSL";
    }
    static constexpr const auto& needs =
        glsl::list<&glsl::tetrahedron_face, &glsl::tetrahedron_face_point, &glsl::tetrahedron_turned,
                   &glsl::project_coordinate, &glsl::shadow_coordinate, &glsl::receiver_slope>;
};

/// Setup of a light with the map of a tetrahedron.
template <real T>
struct set_up_for<tetrahedron_light<T>> {
    using type = tetrahedron_map;
};

}  // namespace umbrage
