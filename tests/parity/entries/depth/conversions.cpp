// SPDX-License-Identifier: MIT
#include <umbrage/depth/conversions.hpp>

#include "../entries.hpp"

namespace parity {

void add_depth_conversions(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;
    const auto anything = depth_values();
    const auto special = special_values();

    all.push_back({.primitive = &glsl::linear_depth,
                   .classes = spread({{0.0f, 100.0f}, {0.01f, 1.0f}}, anything),
                   .twin = [](const sample& s) { return vec4(linear_depth(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_linear_depth(x0.x, x0.y))"});
    all.push_back(
        {.primitive = &glsl::project_depth,
         .classes = spread({{0.0f, 100.0f}, {-10.0f, 100.0f}, {0.0f, 1.0f}}, special),
         .twin = [](const sample& s) { return vec4(project_depth(s.x[0].x, s.x[0].y, s.x[0].z > 0.5f ? 1.0f : 0.0f)); },
         .call = "vec4(umbrage_project_depth(x0.x, x0.y, x0.z > 0.5 ? 1.0 : 0.0))"});
    all.push_back({.primitive = &glsl::distance_depth,
                   .classes = spread({{-50.0f, 50.0f}, {-50.0f, 50.0f}, {-50.0f, 50.0f}, {0.01f, 1.0f}}, special),
                   .twin = [](const sample& s) { return vec4(distance_depth(vec3(s.x[0]), s.x[0].w)); },
                   .call = "vec4(umbrage_distance_depth(vec3(x0.x, x0.y, x0.z), x0.w))"});
    all.push_back({.primitive = &glsl::reverse_depth,
                   .classes = spread({{0.0f, 1.0f}}, anything),
                   .twin = [](const sample& s) { return vec4(reverse_depth(s.x[0].x)); },
                   .call = "vec4(umbrage_reverse_depth(x0.x))"});
    all.push_back({.primitive = &glsl::depth_from_ndc,
                   .classes = spread({{-1.0f, 1.0f}}, anything),
                   .twin = [](const sample& s) { return vec4(depth_from_ndc(s.x[0].x)); },
                   .call = "vec4(umbrage_depth_from_ndc(x0.x))"});
    all.push_back({.primitive = &glsl::view_z_from_depth,
                   .classes = spread({{0.0f, 1.0f}, {0.01f, 1.0f}, {2.0f, 1000.0f}}, special),
                   .twin = [](const sample& s) { return vec4(view_z_from_depth(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_view_z_from_depth(x0.x, x0.y, x0.z))"});
    all.push_back({.primitive = &glsl::depth_from_view_z,
                   .classes = spread({{0.1f, 100.0f}, {0.01f, 1.0f}, {2.0f, 1000.0f}}, special),
                   .twin = [](const sample& s) { return vec4(depth_from_view_z(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_depth_from_view_z(x0.x, x0.y, x0.z))"});
    all.push_back(
        {.primitive = &glsl::view_z_from_reversed_depth,
         .classes = spread({{0.0f, 1.0f}, {0.01f, 1.0f}, {2.0f, 1000.0f}}, special),
         .twin = [](const sample& s) { return vec4(view_z_from_reversed_depth(s.x[0].x, s.x[0].y, s.x[0].z)); },
         .call = "vec4(umbrage_view_z_from_reversed_depth(x0.x, x0.y, x0.z))"});
    all.push_back(
        {.primitive = &glsl::reversed_depth_from_view_z,
         .classes = spread({{0.1f, 100.0f}, {0.01f, 1.0f}, {2.0f, 1000.0f}}, special),
         .twin = [](const sample& s) { return vec4(reversed_depth_from_view_z(s.x[0].x, s.x[0].y, s.x[0].z)); },
         .call = "vec4(umbrage_reversed_depth_from_view_z(x0.x, x0.y, x0.z))"});
    all.push_back(
        {.primitive = &glsl::view_z_from_orthographic_depth,
         .classes = spread({{0.0f, 1.0f}, {-10.0f, 1.0f}, {2.0f, 1000.0f}}, special),
         .twin = [](const sample& s) { return vec4(view_z_from_orthographic_depth(s.x[0].x, s.x[0].y, s.x[0].z)); },
         .call = "vec4(umbrage_view_z_from_orthographic_depth(x0.x, x0.y, x0.z))"});
    all.push_back(
        {.primitive = &glsl::orthographic_depth_from_view_z,
         .classes = spread({{0.1f, 100.0f}, {-10.0f, 1.0f}, {2.0f, 1000.0f}}, special),
         .twin = [](const sample& s) { return vec4(orthographic_depth_from_view_z(s.x[0].x, s.x[0].y, s.x[0].z)); },
         .call = "vec4(umbrage_orthographic_depth_from_view_z(x0.x, x0.y, x0.z))"});
}

}  // namespace parity
