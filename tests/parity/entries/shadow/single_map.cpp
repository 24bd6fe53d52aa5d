// SPDX-License-Identifier: MIT
#include <umbrage/shadow/single_map.hpp>

#include "places.hpp"

namespace parity {

void add_shadow_single_map(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    const std::string arguments =
        "(mat4(x2, x3, x4, x5), mat4(x5, x4, x3, x2), x1, x2, x3, vec4(64.0, 64.0, 2.0, 0.0), vec3(x0.x, x0.y, x0.z), "
        "vec3(x0.w, x1.w, x0.y))";
    const auto add = [&](const snippet& places, const auto& twin) {
        add_places(all, places, points_and_matrices({}), "umbrage_" + std::string(places.name) + arguments,
                   [twin](const sample& s) {
                       const glm::mat4 to_texels(s.x[2], s.x[3], s.x[4], s.x[5]),
                           planes(s.x[5], s.x[4], s.x[3], s.x[2]);
                       return twin(to_texels, planes, s.x[1], s.x[2], s.x[3], umbrage::shadow_terms{}, vec3(s.x[0]),
                                   vec3(s.x[0].w, s.x[1].w, s.x[0].y));
                   });
    };
    add(glsl::single_map_places, [](auto&&... x) { return umbrage::single_map_places(x...); });
    add(glsl::parallel_map_places, [](auto&&... x) { return umbrage::parallel_map_places(x...); });
}

}  // namespace parity
