// SPDX-License-Identifier: MIT
#include <umbrage/core/compare.hpp>

#include <cmath>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Pairs of depths in x0.x and x0.y, and an epsilon in x0.z; in "ties" the pair is equal, or an ulp or the epsilon
/// apart.
std::vector<input_class> pairs() {
    auto classes = spread({{0.0f, 1.0f}, {0.0f, 1.0f}, {0.0f, 0.01f}}, depth_values());
    classes.push_back(
        {"ties", [](std::uint64_t i, random& r, sample& s) {
             const float depth = r.unit(), epsilon = static_cast<float>(r.below(64)) / 4096.0f;
             const float other[] = {depth, std::nextafter(depth, 2.0f), std::nextafter(depth, -1.0f), depth + epsilon};
             s.x[0] = {other[i % 4], depth, epsilon, 0.0f};
         }});
    return classes;
}

}  // namespace

void add_core_compare(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    const auto at_far = [&](const glsl::snippet& one, auto twin) {
        for (const auto direction : {depth_direction::forward, depth_direction::reversed})
            all.push_back(
                {.primitive = &one,
                 .variant = direction == depth_direction::forward ? "" : "reversed",
                 .classes = pairs(),
                 .twin = [=](const sample& s) { return vec4(twin(s.x[0].x, comparison{direction}) ? 1.0f : 0.0f); },
                 .call = "vec4(umbrage_" + std::string(one.name) + "(x0.x) ? 1.0 : 0.0)",
                 .map_kind = {.direction = direction}});
    };
    at_far(glsl::beyond_far_plane,
           [](float receiver, comparison is_lit) { return beyond_far_plane(receiver, is_lit); });
    at_far(glsl::within_far_plane,
           [](float receiver, comparison is_lit) { return within_far_plane(receiver, is_lit); });
    const auto no_far_plane = [](float receiver, float stored) { return receiver < stored; };
    all.push_back(
        {.primitive = &glsl::within_far_plane,
         .variant = "own comparison",
         .classes = pairs(),
         .twin = [=](const sample& s) { return vec4(within_far_plane(s.x[0].x, no_far_plane) ? 1.0f : 0.0f); },
         .call = "vec4(umbrage_within_far_plane(x0.x) ? 1.0 : 0.0)",
         .map_kind = {.compare = "float(receiver < stored)"}});
    all.push_back({.primitive = &glsl::compare,
                   .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(umbrage::compare(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_compare(x0.x, x0.y))"});
    all.push_back({.primitive = &glsl::compare,
                   .variant = "reversed",
                   .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(umbrage::compare(s.x[0].x, s.x[0].y, greater_equal{})); },
                   .call = "vec4(umbrage_compare(x0.x, x0.y))",
                   .map_kind = {.direction = depth_direction::reversed}});
    all.push_back({.primitive = &glsl::compare_dx_sdk,
                   .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(compare_dx_sdk(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_compare_dx_sdk(x0.x, x0.y, x0.z))"});
    all.push_back({.primitive = &glsl::compare_exercise,
                   .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(compare_exercise(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_compare_exercise(x0.x, x0.y, x0.z))"});
}

}  // namespace parity
