// SPDX-License-Identifier: MIT
#include <umbrage/light/texture_matrix.hpp>

#include "../entries.hpp"

namespace parity {

void add_light_texture_matrix(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;
    const auto special = special_values();

    std::vector<range> matrix_and_world(20, range{-20.0f, 20.0f});
    all.push_back(
        {.primitive = &glsl::shadow_coordinate,
         .classes = spread(matrix_and_world, special),
         .twin =
             [](const sample& s) { return shadow_coordinate(glm::mat4(s.x[1], s.x[2], s.x[3], s.x[4]), vec3(s.x[0])); },
         .call = "umbrage_shadow_coordinate(mat4(x1, x2, x3, x4), vec3(x0.x, x0.y, x0.z))"});
    all.push_back(
        {.primitive = &glsl::tap_coordinate,
         .classes = spread(
             {{-99.0f, 99.0f}, {-99.0f, 99.0f}, {0.0f, 9.0f}, {0.1f, 99.0f}, {-2.0f, 2.0f}, {-2.0f, 2.0f}}, special),
         .twin = [](const sample& s) { return tap_coordinate(s.x[0], vec2(s.x[1])); },
         .call = "umbrage_tap_coordinate(x0, vec2(x1.x, x1.y))"});
    all.push_back({.primitive = &glsl::project_coordinate,
                   .classes = spread({{-999.0f, 999.0f}, {-999.0f, 999.0f}, {0.0f, 9.0f}, {-1.0f, 99.0f}}, special),
                   .twin = [](const sample& s) { return vec4(project_coordinate(s.x[0]), 1.0f); },
                   .call = "vec4(umbrage_project_coordinate(x0), 1.0)"});
}

}  // namespace parity
