// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

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

    // No denormals: hardware that takes them for 0 finds a plane and a receiver equal, and gives either. No NaN in
    // planes: min() and max() may then give the receiver or NaN.
    auto placed =
        spread({{0, 1}, {0, 99}, {0, 99}, {0, 1}, {-0.1f, 0.1f}, {-0.1f, 0.1f}, {0, 99}, {0, 99}}, finite_values());
    placed.push_back(
        {"receiver that is no number", [ordinary = placed.front().fill](std::uint64_t i, random& r, sample& s) {
             ordinary(i, r, s);
             constexpr float infinity = std::numeric_limits<float>::infinity();
             s.x[0].x = std::array{std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}[i % 3];
         }});
    // the comparison of apply_receiver_plane: numbers without rounding, some of them equal
    const auto ties = [](std::uint64_t i, random& r, sample& s) {
        const auto sixteenths = [&](int most) { return static_cast<float>(r.below(most)) / 16.0f; };
        const float x = static_cast<float>(r.below(8)), y = static_cast<float>(r.below(8));
        s.x[0] = vec4(sixteenths(17), x + sixteenths(64), y + sixteenths(64), sixteenths(17));
        s.x[1] = vec4(sixteenths(33) - 1.0f, i % 3 == 0 ? 0.0f : sixteenths(33) - 1.0f, x, y);
    };
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const bool forward = direction == depth_direction::forward;
        all.push_back({.primitive = &glsl::plane_reference,
                       .variant = forward ? "" : "reversed",
                       .classes = placed,
                       .twin =
                           [is_lit = comparison{direction}](const sample& s) {
                               return vec4(plane_reference(s.x[0].x, vec2(s.x[1]), vec2(s.x[0].y, s.x[0].z),
                                                           vec2(s.x[1].z, s.x[1].w), is_lit));
                           },
                       .call = "vec4(umbrage_plane_reference(vec2(x1.x, x1.y), vec3(x0.y, x0.z, x0.x), "
                               "vec2(x1.z, x1.w)))",
                       .map_kind = {.direction = direction}});
        all.push_back({.primitive = &glsl::corner_reference,
                       .variant = forward ? "" : "reversed",
                       .classes = placed,
                       .twin =
                           [is_lit = comparison{direction}](const sample& s) {
                               return vec4(corner_reference(s.x[0].x, vec2(s.x[1]), vec2(s.x[0].y, s.x[0].z), is_lit));
                           },
                       .call = "vec4(umbrage_corner_reference(vec2(x1.x, x1.y), vec2(x0.y, x0.z), x0.x))",
                       .map_kind = {.direction = direction}});
        all.push_back({.primitive = &glsl::bordered_plane_reference,
                       .variant = forward ? "" : "reversed",
                       .classes = placed,
                       .twin =
                           [is_lit = comparison{direction}](const sample& s) {
                               const vec2 texel(s.x[1].z, s.x[1].w), inside(texel.x, s.x[0].w);
                               return vec4(bordered_plane_reference(s.x[0].x, vec2(s.x[1]), vec2(s.x[0].y, s.x[0].z),
                                                                    texel, inside, is_lit),
                                           bordered_plane_reference(s.x[0].x, vec2(s.x[1]), vec2(s.x[0].y, s.x[0].z),
                                                                    texel, vec2(inside.y, texel.y), is_lit),
                                           bordered_plane_reference(s.x[0].x, vec2(s.x[1]), vec2(s.x[0].y, s.x[0].z),
                                                                    texel, texel, is_lit),
                                           1.0f);
                           },
                       .call = "vec4(umbrage_bordered_plane_reference(vec2(x1.x, x1.y), vec3(x0.y, x0.z, x0.x), "
                               "vec2(x1.z, x1.w), vec2(x1.z, x0.w)), "
                               "umbrage_bordered_plane_reference(vec2(x1.x, x1.y), vec3(x0.y, x0.z, x0.x), "
                               "vec2(x1.z, x1.w), vec2(x0.w, x1.w)), "
                               "umbrage_bordered_plane_reference(vec2(x1.x, x1.y), vec3(x0.y, x0.z, x0.x), "
                               "vec2(x1.z, x1.w), vec2(x1.z, x1.w)), 1.0)",
                       .map_kind = {.direction = direction}});
        all.push_back(
            {.primitive = &glsl::apply_receiver_plane,
             .variant = forward ? "" : "reversed",
             .classes = {{"ties", ties}},
             .twin =
                 [direction](const sample& s) {
                     const auto stored = [&](ivec2) { return s.x[0].w; };
                     const vec3 at(s.x[0].y, s.x[0].z, s.x[0].x);
                     return vec4(apply_receiver_plane(stored, vec2(s.x[1]), at, direction)(ivec2(s.x[1].z, s.x[1].w)));
                 },
             .call = "vec4(umbrage_apply_receiver_plane(x0.w, vec2(x1.x, x1.y), vec3(x0.y, x0.z, x0.x), "
                     "vec2(x1.z, x1.w)))",
             .map_kind = {.direction = direction}});
    }
}

}  // namespace parity
