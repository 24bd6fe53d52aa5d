// SPDX-License-Identifier: MIT
#include <umbrage/shadow/paraboloid_maps.hpp>

#include "places.hpp"

namespace parity {

void add_shadow_paraboloid_maps(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    add_places(all, glsl::paraboloid_maps_places, points_and_matrices({}),
               "umbrage_paraboloid_maps_places(x1, x2, x4, vec4(64.0, 64.0, 2.0, 0.0), vec3(x0.x, x0.y, x0.z), "
               "vec3(x3.x, x3.y, x3.z))",
               [](const sample& s) {
                   return umbrage::paraboloid_maps_places(s.x[1], s.x[2], s.x[4], {}, vec3(s.x[0]), vec3(s.x[3]));
               });
    auto vertices = points_and_matrices({});
    for (input_class& c : vertices)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(i % 2);
        };
    all.push_back({.primitive = &glsl::paraboloid_vertex,
                   .classes = std::move(vertices),
                   .twin =
                       [](const sample& s) {
                           const glm::mat4 to_clip(s.x[2], s.x[3], s.x[4], s.x[5]);
                           return umbrage::paraboloid_vertex(to_clip, vec3(s.x[0]), s.x[1], s.x[0].w);
                       },
                   .call = "umbrage_paraboloid_vertex(mat4(x2, x3, x4, x5), vec3(x0.x, x0.y, x0.z), "
                           "x1, x0.w)"});
}

}  // namespace parity
