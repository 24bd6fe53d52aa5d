// SPDX-License-Identifier: MIT
#include <umbrage/light/point/dual_paraboloid.hpp>

#include "../../entries.hpp"

namespace parity {

void add_light_point_dual_paraboloid(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;
    auto directions = spread({{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f}, {0.0f, 1.0f}}, special_values());
    directions.push_back({"between the maps", [](std::uint64_t, random& r, sample& s) {
                              for (int axis = 0; axis < 3; ++axis) s.x[0][axis] = r.between(-9.0f, 9.0f);
                              const float halves[]{0.5f, 0.50000006f};
                              s.x[0].w = halves[r.below(2)];
                              if (r.below(2) == 0) s.x[0].z = 0.0f;
                          }});

    all.push_back({.primitive = &glsl::dual_paraboloid_coordinate,
                   .classes = directions,
                   .twin = [](const sample& s) { return vec4(dual_paraboloid_coordinate(vec3(s.x[0])), 1.0f); },
                   .call = "vec4(umbrage_dual_paraboloid_coordinate(vec3(x0.x, x0.y, x0.z)), 1.0)"});
    all.push_back({.primitive = &glsl::dual_paraboloid_position,
                   .classes = directions,
                   .twin = [](const sample& s) { return dual_paraboloid_position(vec3(s.x[0]), s.x[0].w); },
                   .call = "umbrage_dual_paraboloid_position(vec3(x0.x, x0.y, x0.z), x0.w)"});
}

}  // namespace parity
