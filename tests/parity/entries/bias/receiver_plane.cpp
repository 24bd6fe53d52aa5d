// SPDX-License-Identifier: MIT
#include <umbrage/bias/receiver_plane.hpp>

#include "limits.hpp"

namespace parity {

void add_bias_receiver_plane(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    // derivatives, of pixels as wide as some texels and as a few hundredths of one
    auto pixels =
        spread({{-2, 2}, {-2, 2}, {-0.01f, 0.01f}, {0, 1}, {-2, 2}, {-2, 2}, {-0.01f, 0.01f}}, special_values());
    pixels.push_back({"in line", [](std::uint64_t i, random& r, sample& s) {
                          const vec3 d{r.between(-2, 2), r.between(-2, 2), r.between(-0.01f, 0.01f)};
                          const float longer = std::array{1.0f, 2.0f, -0.5f, 1.0f + 0x1p-9f}[i % 4];
                          s.x[0] = vec4(d, 0.0f);
                          s.x[1] = vec4(d.x * longer, i % 8 < 4 ? d.y * longer : d.y, d.z, 0.0f);
                      }});
    pixels.push_back({"as small or as wide as pixels may be", [](std::uint64_t i, random& r, sample& s) {
                          const float edge = i % 2 ? 0x1p-9f : 0x1p63f, depth = edge * r.between(-0.5f, 0.5f);
                          const float beside[] = {edge, std::nextafter(edge, 0.0f), std::nextafter(edge, 0x1p65f)};
                          s.x[0] = vec4(beside[i / 2 % 3], 0.0f, depth, 0.0f);
                          s.x[1] = vec4(0.0f, beside[i / 6 % 3], depth, 0.0f);
                      }});
    all.push_back({.primitive = &glsl::receiver_plane_slope,
                   .classes = pixels,
                   .twin = [](const sample& s) { return vec4(receiver_plane_slope(vec3(s.x[0]), vec3(s.x[1])), 0.0f); },
                   .call = "vec4(umbrage_receiver_plane_slope(vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z)), 0.0)"});

    auto stored =
        spread({{0, 1}, {0, 99}, {0, 99}, {0, 0}, {-0.1f, 0.1f}, {-0.1f, 0.1f}, {0, 99}, {0, 99}}, values_and_limits());
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        all.push_back({.primitive = &glsl::apply_receiver_plane,
                       .variant = direction == depth_direction::forward ? "" : "reversed",
                       .classes = stored,
                       .twin =
                           [far = cleared_depth(direction)](const sample& s) {
                               return vec4(apply_receiver_plane(s.x[0].x, vec2(s.x[1]), vec2(s.x[0].y, s.x[0].z),
                                                                vec2(s.x[1].z, s.x[1].w), far));
                           },
                       .call = "vec4(umbrage_apply_receiver_plane(x0.x, vec2(x1.x, x1.y), vec2(x0.y, x0.z), "
                               "vec2(x1.z, x1.w)))",
                       .map_kind = {.direction = direction}});
}

}  // namespace parity
