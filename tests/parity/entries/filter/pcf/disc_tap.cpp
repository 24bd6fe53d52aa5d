// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/disc_tap.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// An integer in either direction.
float whole(random& r, int below) { return static_cast<float>(r.below(2 * below + 1) - below); }

/// position x0.xy, point x0.zw, rotation x1 and radii x2.xy of disc_tap.
std::vector<input_class> taps() {
    return {{"random",
             [](auto, random& r, sample& s) {
                 s.x[0] = {whole(r, 1 << 23), whole(r, 1 << 23), whole(r, 16), whole(r, 16)};
                 s.x[1] = disc_rotation(vec2{static_cast<float>(r.below(4)), static_cast<float>(r.below(4))});
                 s.x[2] = {static_cast<float>(r.below(4096)), static_cast<float>(r.below(4096)), 0.0f, 0.0f};
             }},
            {"texel edges", [](std::uint64_t i, random& r, sample& s) {
                 s.x[0] = {whole(r, 1 << 10) * 256.0f, whole(r, 1 << 10) * 256.0f, i % 2 ? 16.0f : -16.0f, 0.0f};
                 const float c = i & 4 ? 64.0f : 0.0f, up = i & 4 ? 0.0f : -64.0f;
                 s.x[1] = {c, -up, up, c};
                 s.x[2] = vec4(static_cast<float>(r.below(256)) * 16.0f);
             }}};
}

}  // namespace

void add_filter_pcf_disc_tap(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    all.push_back({.primitive = &glsl::disc_rotation,
                   .classes = spread({{-40.0f, 4000.0f}, {-40.0f, 4000.0f}}, special_values()),
                   .twin = [](const sample& s) { return disc_rotation(vec2(s.x[0])); },
                   .call = "umbrage_disc_rotation(vec2(x0.x, x0.y))"});
    all.push_back(
        {.primitive = &glsl::sheared_rotation,
         .classes = spread({{-64.0f, 64.0f}, {-64.0f, 64.0f}, {-64.0f, 64.0f}, {-64.0f, 64.0f}, {-8.0f, 8.0f}}, {}),
         .twin = [](const sample& s) { return sheared_rotation(s.x[0], s.x[1].x); },
         .call = "umbrage_sheared_rotation(x0, x1.x)"});
    all.push_back({.primitive = &glsl::disc_tap,
                   .classes = taps(),
                   .twin =
                       [](const sample& s) {
                           const vec4 x = s.x[0];
                           const vec2 texel = disc_tap(vec2(x), vec2(x.z, x.w), s.x[1], vec2(s.x[2]));
                           return vec4(texel.x, texel.y, 0.0f, 0.0f);
                       },
                   .call = "vec4(umbrage_disc_tap(vec2(x0.x, x0.y), vec2(x0.z, x0.w), x1, vec2(x2.x, x2.y)), "
                           "0.0, 0.0)"});
    all.push_back({.primitive = &glsl::disc_radius,
                   .classes = spread({{-1.0f, 300.0f}}, special_values()),
                   .twin = [](const sample& s) { return vec4(disc_radius(s.x[0].x)); },
                   .call = "vec4(umbrage_disc_radius(x0.x))"});
}

}  // namespace parity
