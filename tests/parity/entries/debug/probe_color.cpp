// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>

#include <umbrage/debug/probe_color.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

/// Either side of 2^64, from which on nothing is usable, and far from there.
float around_limit(random& r) {
    constexpr float limit = 0x1p64f;
    const float values[]{limit,
                         std::nextafter(limit, 0.0f),
                         std::nextafter(limit, 2 * limit),
                         0.75f * limit,
                         0.9f * limit,
                         1.1f * limit,
                         1.5f * limit,
                         0x1p54f,
                         0x1p74f};
    const float sign = r.below(2) == 0 ? 1.0f : -1.0f;
    return sign * values[r.below(9)];
}

/// (x, y, depth, bias) and (size, number) of receivers inside, and on both sides of every border.
std::vector<input_class> places() {
    constexpr float width = 40, height = 24;
    const auto fill = [](random& r, sample& s) {
        s.x[0] = {r.between(0, width), r.between(0, height), r.between(0, 1), r.between(0, 0.9f)};
        s.x[1] = {width, height, static_cast<float>(r.below(20)), 0};
    };
    std::vector<input_class> classes{
        {"random", [=](std::uint64_t, random& r, sample& s) { fill(r, s); }},
        {"borders",
         [=](std::uint64_t i, random& r, sample& s) {
             fill(r, s);
             const float edges[][4]{{0, 0, 0, 1}, {width, height, 1, 1}, {65536, 65536, 0, 1}};
             const int axis = r.below(4);
             const float edge = edges[i % 3][axis];
             const float beside[]{edge, std::nextafter(edge, 1e9f), std::nextafter(edge, -1.0f), edge - 0.25f,
                                  edge + 0.25f};
             s.x[0][axis] = beside[r.below(5)];
             if (i % 7) return;
             const int other = r.below(4);
             s.x[0][other] = static_cast<float>(r.below(3)) * 65536.0f;
         }},
        {"usable", [=](std::uint64_t i, random& r, sample& s) {
             fill(r, s);
             s.x[0][static_cast<int>(i % 3)] = around_limit(r);
         }}};
    for (const value_class& kind : large_values())
        classes.push_back({kind.name, [=](std::uint64_t i, random& r, sample& s) {
                               fill(r, s);
                               s.x[0][static_cast<int>(i % 4)] = kind.make(i, r);
                           }});
    return classes;
}

/// A color, a position and a normal, each of whose components may be anything.
std::vector<input_class> inputs() {
    const auto fill = [](std::uint64_t i, random& r, sample& s) {
        s.x[0] = {0.25f, 0.5f, 0.75f, 0};
        s.x[1] = {r.between(-9, 9), r.between(-9, 9), r.between(-9, 9), 0};
        s.x[2] = i % 3 ? vec4{r.between(-1, 1), r.between(-1, 1), r.between(-1, 1), 0} : vec4(0);
        if (i % 3 == 0 && i % 2) s.x[2][r.below(3)] = 1;
    };
    std::vector<input_class> classes{{"random", fill}, {"usable", [=](std::uint64_t i, random& r, sample& s) {
                                                            fill(i, r, s);
                                                            const int axis = r.below(3);
                                                            s.x[1 + i % 2][axis] = around_limit(r);
                                                        }}};
    for (const value_class& kind : large_values())
        classes.push_back({kind.name, [=](std::uint64_t i, random& r, sample& s) {
                               fill(i, r, s);
                               const int which = 1 + r.below(2), axis = r.below(3);
                               s.x[static_cast<std::size_t>(which)][axis] = kind.make(i, r);
                           }});
    return classes;
}

}  // namespace

void add_debug_probe_color(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        all.push_back({.primitive = &glsl::probe_color,
                       .variant = direction == depth_direction::forward ? "" : "reversed",
                       .classes = places(),
                       .twin =
                           [direction](const sample& s) {
                               return vec4(
                                   probe_color(glm::vec3(s.x[0]), glm::vec2(s.x[1]), s.x[0].w, s.x[1].z, direction), 0);
                           },
                       .call = "vec4(umbrage_probe_color(vec3(x0.x, x0.y, x0.z), vec2(x1.x, x1.y), x0.w, x1.z), 0.0)",
                       .map_kind = {.direction = direction}});
    all.push_back({.primitive = &glsl::probe_inputs,
                   .classes = inputs(),
                   .twin =
                       [](const sample& s) {
                           return vec4(probe_inputs(glm::vec3(s.x[0]), glm::vec3(s.x[1]), glm::vec3(s.x[2])), 0);
                       },
                   .call = "vec4(umbrage_probe_inputs(vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z), vec3(x2.x, x2.y, "
                           "x2.z)), 0.0)"});
}

}  // namespace parity
