// SPDX-License-Identifier: MIT
//
// Shadow with one map, of a spot light or of a directional light, whose map may be fitted or warped.
//
//     umbrage::shadow lamp(umbrage::make_spot_light({...}), {1024, 1024}, umbrage::filters::tent<3>);
//
#pragma once

#include <umbrage/bias/slope.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

/// Setup of one map.
struct single_map {
    light_space<double> light;

    template <real T>
    explicit single_map(const light_space<T>& space) : light(detail::in_double(space)) {}

    struct uniforms {
        glm::mat4 to_texels;  ///< texture_matrix
        glm::mat4 planes;     ///< plane_matrix of to_texels
    };
    static constexpr uniform_field fields[]{{"to_texels"}, {"planes"}};
    static constexpr map_grid grid{1, 1};
    static constexpr outside_map outside = outside_map::bordered;
    static constexpr glsl::map_choice tiles{};

    [[nodiscard]] clip_space clip() const { return light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const { return {light}; }
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        const glm::dmat4 to_texels = texture_matrix(detail::relative_to(origin, light), map_size);
        return {glm::mat4(to_texels), glm::mat4(plane_matrix(to_texels))};
    }

    [[nodiscard]] static map_place place(const uniforms& u, glm::vec3 world, glm::vec3 normal) {
        const glm::vec3 at = project_coordinate(shadow_coordinate(u.to_texels, world));
        return {0, at, receiver_slope(u.planes, normal, world)};
    }
    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms&, glm::vec3 world, glm::vec3 normal,
                                          const Look& look) {
        return look(place(u, world, normal));
    }
    [[nodiscard]] static std::string text(const glsl::map_choice&) {
        return R"GLSL(
    UMBRAGE_HIGHP vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world));
    return umbrage_look(map, terms, filter_terms, at, umbrage_receiver_slope(planes, normal, world));
)GLSL";
    }
    static constexpr const auto& needs =
        glsl::list<&glsl::project_coordinate, &glsl::shadow_coordinate, &glsl::receiver_slope>;
};

/// Setup of a light with one map.
template <real T>
struct set_up_for<light_space<T>> {
    using type = single_map;
};

}  // namespace umbrage
