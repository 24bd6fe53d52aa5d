// SPDX-License-Identifier: MIT
#include <umbrage/shadow/anchored_map.hpp>

#include <array>

#include "places.hpp"

namespace parity {

void add_shadow_anchored_map(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    add_places(all, glsl::anchored_place, points_and_matrices({{-20.0f, 20.0f}, {-20.0f, 20.0f}}),
               "umbrage_anchored_place(mat4(x2, x3, x4, x5), mat4(x5, x4, x3, x2), x1, x2, vec3(x0.x, x0.y, x0.z), "
               "vec3(x0.w, x1.y, x0.y))",
               [](const sample& s) {
                   const glm::mat4 to_texels(s.x[2], s.x[3], s.x[4], s.x[5]), planes(s.x[5], s.x[4], s.x[3], s.x[2]);
                   return std::array{umbrage::anchored_place(to_texels, planes, s.x[1], s.x[2], vec3(s.x[0]),
                                                             vec3(s.x[0].w, s.x[1].y, s.x[0].y))};
               });
    all.push_back({.primitive = &glsl::anchored_vertex,
                   .classes = points_and_matrices({{-20.0f, 20.0f}, {-20.0f, 20.0f}}),
                   .twin =
                       [](const sample& s) {
                           const glm::mat4 to_clip(s.x[2], s.x[3], s.x[4], s.x[5]);
                           return umbrage::anchored_vertex(to_clip, vec3(s.x[0]), s.x[1]);
                       },
                   .call = "umbrage_anchored_vertex(mat4(x2, x3, x4, x5), vec3(x0.x, x0.y, x0.z), x1)"});
}

}  // namespace parity
