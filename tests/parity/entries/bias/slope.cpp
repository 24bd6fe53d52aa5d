// SPDX-License-Identifier: MIT
#include <umbrage/bias/slope.hpp>

#include "limits.hpp"

namespace parity {

void add_bias_slope(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;
    const auto special = special_values();

    all.push_back({.primitive = &glsl::clamp_slope,
                   .classes = spread({{-3.0f, 3.0f}}, values_and_limits()),
                   .twin = [](const sample& s) { return vec4(clamp_slope(s.x[0].x)); },
                   .call = "vec4(umbrage_clamp_slope(x0.x))"});
    const std::vector<range> normal_point_matrix(24, range{-2.0f, 2.0f});
    all.push_back({.primitive = &glsl::plane_in_map,
                   .classes = spread(normal_point_matrix, special),
                   .twin =
                       [](const sample& s) {
                           const glm::mat4 planes(s.x[2], s.x[3], s.x[4], s.x[5]);
                           return vec4(plane_in_map(planes, vec3(s.x[0]), vec3(s.x[1])), 0.0f);
                       },
                   .call = "vec4(umbrage_plane_in_map(mat4(x2, x3, x4, x5), vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, "
                           "x1.z)), 0.0)"});
    all.push_back(
        {.primitive = &glsl::plane_slope,
         .classes = spread(normal_point_matrix, special),
         .twin =
             [](const sample& s) {
                 const glm::mat4 planes(s.x[2], s.x[3], s.x[4], s.x[5]);
                 return vec4(plane_slope(planes, vec3(s.x[0]), vec3(s.x[1])), 0.0f, 0.0f);
             },
         .call = "vec4(umbrage_plane_slope(mat4(x2, x3, x4, x5), vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z)), "
                 "0.0, 0.0)"});
    const auto with_no_normal = [](std::vector<input_class> classes) {
        classes.push_back(
            {"no normal, or along an axis", [spread = classes[0].fill](std::uint64_t i, random& r, sample& s) {
                 spread(i, r, s);
                 for (int k = 0; k < 3; ++k)
                     if (i % 4 != static_cast<std::uint64_t>(k)) s.x[0][k] = 0.0f;
                 if (i % 3 == 0) s.x[1].x = 0.0f;
                 const auto half = [&](std::uint64_t bit) { return i & bit ? 0.5f : -0.5f; };
                 if (i % 5 == 4) s.x[0] = {half(1), half(2), 0.0f, s.x[0].w};  // components that cancel
             }});
        return classes;
    };
    auto receivers = with_no_normal(spread(normal_point_matrix, special));
    receivers.push_back({"axes of the map along those of the world, one number of the normal 0",
                         [ordinary = receivers[0].fill](std::uint64_t i, random& r, sample& s) {
                             ordinary(i, r, s);
                             for (int k = 0; k < 4; ++k)
                                 for (int row = 0; row < 4; ++row)
                                     if (k != row) s.x[2 + k][row] = 0.0f;
                             s.x[0][static_cast<int>(i % 2)] = 0.0f;
                         }});
    all.push_back(
        {.primitive = &glsl::receiver_slope,
         .classes = receivers,
         .twin =
             [](const sample& s) {
                 const glm::mat4 planes(s.x[2], s.x[3], s.x[4], s.x[5]);
                 return vec4(receiver_slope(planes, vec3(s.x[0]), vec3(s.x[1])), 0.0f, 0.0f);
             },
         .call = "vec4(umbrage_receiver_slope(mat4(x2, x3, x4, x5), vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z)), "
                 "0.0, 0.0)"});
    all.push_back({.primitive = &glsl::cascade_slope,
                   .classes = with_no_normal(spread(std::vector<range>(8, range{-2.0f, 2.0f}), large_values())),
                   .twin = [](const sample& s) { return vec4(cascade_slope(vec3(s.x[0]), s.x[1]), 0.0f, 0.0f); },
                   .call = "vec4(umbrage_cascade_slope(vec3(x0.x, x0.y, x0.z), x1), 0.0, 0.0)"});
    all.push_back({.primitive = &glsl::slope_bias,
                   .classes = spread({{-0.1f, 0.1f}, {-0.1f, 0.1f}, {0.0f, 9.0f}, {0.0f, 0.1f}}, special),
                   .twin = [](const sample& s) { return vec4(slope_bias(vec2(s.x[0]), s.x[0].z, s.x[0].w)); },
                   .call = "vec4(umbrage_slope_bias(vec2(x0.x, x0.y), x0.z, x0.w))"});
}

}  // namespace parity
