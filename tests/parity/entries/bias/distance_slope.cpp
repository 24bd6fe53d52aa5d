// SPDX-License-Identifier: MIT
#include <umbrage/bias/distance_slope.hpp>

#include "../entries.hpp"

namespace parity {

void add_bias_distance_slope(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    auto classes = spread(
        {{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f}, {1e-5f, 0.01f}, {-1.0f, 1.0f}, {-1.0f, 1.0f}, {-1.0f, 1.0f}},
        large_values());
    classes.push_back(
        {"no normal, or along an axis", [spread = classes[0].fill](std::uint64_t i, random& r, sample& s) {
             spread(i, r, s);
             for (int k = 0; k < 3; ++k)
                 if (i % 4 != static_cast<std::uint64_t>(k)) s.x[1][k] = 0.0f;
         }});
    all.push_back({.primitive = &glsl::dual_paraboloid_slope,
                   .classes = classes,
                   .twin =
                       [](const sample& s) {
                           return vec4(dual_paraboloid_slope(vec3(s.x[0]), vec3(s.x[1]), s.x[0].w), 0.0f, 0.0f);
                       },
                   .call = "vec4(umbrage_dual_paraboloid_slope(vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z), x0.w), "
                           "0.0, 0.0)"});
}

}  // namespace parity
