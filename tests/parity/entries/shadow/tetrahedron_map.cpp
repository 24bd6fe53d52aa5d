// SPDX-License-Identifier: MIT
#include <umbrage/shadow/tetrahedron_map.hpp>

#include "places.hpp"

namespace parity {

void add_shadow_tetrahedron_map(std::vector<entry>& all) {
    add_places(all, umbrage::glsl::tetrahedron_map_places, points_and_matrices({}),
               "umbrage_tetrahedron_map_places(mat4(x2, x3, x4, x5), mat4(x5, x4, x3, x2), x1, x2, x3, "
               "vec4(32.0, 0.0, 0.0, 0.0), vec4(64.0, 64.0, 2.0, 0.0), vec3(x0.x, x0.y, x0.z), vec3(x0.w, x1.w, x0.y))",
               [](const sample& s) {
                   const glm::mat4 to_texels(s.x[2], s.x[3], s.x[4], s.x[5]), planes(s.x[5], s.x[4], s.x[3], s.x[2]);
                   return umbrage::tetrahedron_map_places(to_texels, planes, s.x[1], s.x[2], s.x[3], vec4(32, 0, 0, 0),
                                                          {}, vec3(s.x[0]), vec3(s.x[0].w, s.x[1].w, s.x[0].y));
               });
    const auto places = [](std::uint64_t i, random& r, sample& s) {
        s.x[0] = {64.0f * r.unit(), 64.0f * r.unit(), 0.0f, 0.0f};
        if (i % 4 == 0) s.x[0].y = i % 8 ? s.x[0].x : 64.0f - s.x[0].x;  // on the seams
    };
    all.push_back({.primitive = &umbrage::glsl::tetrahedron_shape,
                   .classes = {{"texels", places}},
                   .twin =
                       [](const sample& s) {
                           return vec4(umbrage::tetrahedron_shape(vec4(32, 0, 0, 0), 0.0f, vec2(s.x[0])), 1.0f);
                       },
                   .call = "vec4(umbrage_tetrahedron_shape(vec4(32.0, 0.0, 0.0, 0.0), 0.0, vec2(x0.x, x0.y)), 1.0)"});
}

}  // namespace parity
