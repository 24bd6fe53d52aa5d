// SPDX-License-Identifier: MIT
#include <umbrage/shadow/cube_maps.hpp>

#include <vector>

#include "places.hpp"

namespace parity {

void add_shadow_cube_maps(std::vector<entry>& all) {
    auto classes = points_and_matrices({});  // a NaN makes the place lit, on whatever face
    std::erase_if(classes, [](const input_class& c) { return c.name == "NaN"; });
    classes.push_back({"between faces", [ordinary = classes.front().fill](std::uint64_t i, random& r, sample& s) {
                           ordinary(i, r, s);
                           const float t = r.below(2) == 0 ? 0.5f : -0.5f, x = r.below(2) == 0 ? 0.25f : 0.5f;
                           s.x[2] = vec4(0.5f, -0.25f, 0.75f, 0.0f);
                           s.x[0] = s.x[2] + vec4(x, t, r.below(2) == 0 ? 0.5f : -0.5f, 0.0f);
                       }});
    add_places(all, umbrage::glsl::cube_maps_places, classes,
               "umbrage_cube_maps_places(x1, x2, x3, x4, vec4(64.0, 64.0, 2.0, 0.0), vec3(x0.x, x0.y, x0.z), "
               "vec3(x5.x, x5.y, x5.z))",
               [](const sample& s) {
                   return umbrage::cube_maps_places(s.x[1], s.x[2], s.x[3], s.x[4], {}, vec3(s.x[0]), vec3(s.x[5]));
               });
}

}  // namespace parity
