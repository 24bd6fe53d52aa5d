// SPDX-License-Identifier: MIT
#include <umbrage/shadow/single_map.hpp>

#include "places.hpp"

namespace parity {

void add_shadow_single_map(std::vector<entry>& all) {
    add_places(all, umbrage::glsl::single_map_places, points_and_matrices({}),
               "umbrage_single_map_places(mat4(x2, x3, x4, x5), mat4(x5, x4, x3, x2), x1, x2, x3, "
               "vec4(64.0, 64.0, 2.0, 0.0), vec3(x0.x, x0.y, x0.z), vec3(x0.w, x1.w, x0.y))",
               [](const sample& s) {
                   const glm::mat4 to_texels(s.x[2], s.x[3], s.x[4], s.x[5]), planes(s.x[5], s.x[4], s.x[3], s.x[2]);
                   return umbrage::single_map_places(to_texels, planes, s.x[1], s.x[2], s.x[3], {}, vec3(s.x[0]),
                                                     vec3(s.x[0].w, s.x[1].w, s.x[0].y));
               });
}

}  // namespace parity
