// SPDX-License-Identifier: MIT
#include <umbrage/shadow/warped_places.hpp>

#include <array>
#include <cmath>
#include <string>

#include "places.hpp"

namespace parity {
namespace {

/// Matrices of the four maps: the columns of x2 to x5, begun with another one in each.
std::array<glm::mat4, 4> in_turn(const sample& s, std::size_t first) {
    std::array<glm::mat4, 4> all;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) all[i][static_cast<glm::length_t>(k)] = s.x[2 + (first + i + k) % 4];
    return all;
}

}  // namespace

void add_shadow_warped_places(std::vector<entry>& all) {
    auto classes = points_and_matrices({{-2.0f, 2.0f}, {-2.0f, 2.0f}, {-2.0f, 2.0f}, {-0.25f, 0.25f}});
    for (input_class& c : classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[1].w = static_cast<float>(r.below(4));
        };
    const std::string a = "mat4(x2, x3, x4, x5)", b = "mat4(x3, x4, x5, x2)", c = "mat4(x4, x5, x2, x3)",
                      d = "mat4(x5, x2, x3, x4)";
    std::string maps;
    for (const std::string& map : {a, b, c, d, b, c, d, a}) maps += map + ", ";
    const std::string ends = "vec4(-1.0, 0.25, 1.0, x1.w)",
                      fades =
                          "mat4(vec4(0.25, 1.0, 0.0, 0.0), vec4(0.5, 0.0, 0.0, 0.0), vec4(0.75, -0.5, 0.0, 0.0), "
                          "vec4(1.0, -1.5, 0.0, 0.0))";
    const std::string anchor = "vec4(x1.y, x1.z, x1.x, 0.0)", ahead = "vec4(0.5, -0.25, 1.0, x0.w)";
    auto exact = classes;  // sums that no order rounds: a weight changes by steps
    for (input_class& one : exact)
        one.fill = [fill = one.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            for (vec4* v : {&s.x[0], &s.x[1]})
                for (glm::length_t k = 0; k < 4; ++k)
                    if (std::abs((*v)[k]) < 4.0f) (*v)[k] = std::round((*v)[k] * 1024.0f) / 1024.0f;
        };
    all.push_back({.primitive = &umbrage::glsl::warped_maps_choice,
                   .classes = exact,
                   .twin =
                       [](const sample& s) {
                           const glm::mat4 of(vec4(0.25f, 1.0f, 0.0f, 0.0f), vec4(0.5f, 0.0f, 0.0f, 0.0f),
                                              vec4(0.75f, -0.5f, 0.0f, 0.0f), vec4(1.0f, -1.5f, 0.0f, 0.0f));
                           return vec4(umbrage::warped_maps_choice(of, vec4(s.x[1].y, s.x[1].z, s.x[1].x, 0.0f),
                                                                   vec4(0.5f, -0.25f, 1.0f, s.x[0].w),
                                                                   vec4(-1.0f, 0.25f, 1.0f, s.x[1].w), vec3(s.x[0])),
                                       0, 0);
                       },
                   .call = "vec4(umbrage_warped_maps_choice(" + fades + ", " + anchor + ", " + ahead + ", " + ends +
                           ", vec3(x0.x, x0.y, x0.z)), 0.0, 0.0)"});
    for (input_class& one : classes)
        one.fill = [fill = one.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(r.below(5));
        };
    add_places(all, umbrage::glsl::warped_maps_place, classes,
               "umbrage_warped_maps_place(" + maps + "mat4(x3, x2, x5, x4), mat4(x4, x5, x2, x3), " + fades + ", " +
                   anchor + ", " + ahead + ", " + ends +
                   ", vec4(64.0, 64.0, 2.0, 0.0), vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z), x0.w)",
               [](const sample& s) {
                   return std::array{umbrage::warped_maps_place(
                       in_turn(s, 0), in_turn(s, 1), glm::mat4(s.x[3], s.x[2], s.x[5], s.x[4]),
                       glm::mat4(s.x[4], s.x[5], s.x[2], s.x[3]), vec4(s.x[1].y, s.x[1].z, s.x[1].x, 0.0f),
                       vec4(-1.0f, 0.25f, 1.0f, s.x[1].w), vec3(s.x[0]), vec3(s.x[1]), s.x[0].w)};
               });
}

}  // namespace parity
