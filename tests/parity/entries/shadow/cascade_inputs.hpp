// SPDX-License-Identifier: MIT
//
// Inputs of the entries of cascades: their choice, and places in them.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "places.hpp"

namespace parity::cascades {

using umbrage::shadow_terms;

/// Size of a map and reach of a filter: by x1.z, which is 1, so that no compiler knows them.
[[nodiscard]] inline shadow_terms in_64(const sample& s) {
    return {.map_size = vec2(64.0f, 48.0f) * s.x[1].z, .reach = 2.0f * s.x[1].z};
}

/// A point in x0.xyz before four cascades of 64 x 64 texels, each with half of the scale before it, x1.xyz; offsets in
/// x2 to x5; a normal in the fourth components, and the number of the last cascade in x0.w.
[[nodiscard]] inline std::vector<input_class> nested(const std::vector<value_class>& kinds = large_values()) {
    const range offset{24.0f, 40.0f}, depth{-0.25f, 0.25f}, tilt{-1.0f, 1.0f};
    auto classes = spread(
        {{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-0.25f, 1.25f}, {0.0f, 4.0f}, {2.0f, 16.0f}, {2.0f, 16.0f}, {1.0f, 1.0f}, tilt,
         offset,        offset,        depth,           tilt,         offset,        offset,        depth,        tilt,
         offset,        offset,        depth,           tilt,         offset,        offset,        depth,        tilt},
        kinds);
    for (input_class& c : classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(r.below(4));
        };
    return classes;
}

[[nodiscard]] inline vec3 normal_of(const sample& s) { return {s.x[2].w, s.x[3].w, s.x[4].w}; }
[[nodiscard]] inline vec4 blending_of(const sample& s) { return {0.125f, s.x[0].w, 0.0f, 0.0f}; }

[[nodiscard]] inline glm::mat4 scales(const sample& s) {
    glm::mat4 m(0.0f);
    for (glm::length_t i = 0; i < 4; ++i)
        m[i] = vec4(vec2(s.x[1]) * std::ldexp(1.0f, -static_cast<int>(i)), 1.0f, s.x[1].y * 0.5f);
    return m;
}

/// Axes of a light, nearly: no component is 0, of which a compiler makes 0 whatever it is multiplied with.
inline constexpr auto turned =
    "mat4(vec4(0.25, 1.0, 0.015625, 1.0), vec4(1.0, -0.25, 0.015625, 1.0), vec4(0.0625, 0.125, 1.0, 1.0), "
    "vec4(0.5, -0.5, 0.03125, 1.0))";
inline const glm::mat4 axes(vec4(0.25f, 1, 0.015625f, 1), vec4(1, -0.25f, 0.015625f, 1), vec4(0.0625f, 0.125f, 1, 1),
                            vec4(0.5f, -0.5f, 0.03125f, 1));
inline const vec4 anchor(0.25f, -0.5f, 0.125f, 0.0f);
inline constexpr auto all_scales =
    "mat4(vec4(x1.x, x1.y, 1.0, x1.y * 0.5), vec4(vec2(x1.x, x1.y) * 0.5, 1.0, x1.y * 0.5), "
    "vec4(vec2(x1.x, x1.y) * 0.25, 1.0, x1.y * 0.5), vec4(vec2(x1.x, x1.y) * 0.125, 1.0, x1.y * 0.5))";
inline constexpr auto all_farther =
    "mat4(vec4(vec2(x1.x, x1.y) * 0.0625, 1.0, x1.y * 0.5), vec4(vec2(x1.x, x1.y) * 0.03125, 1.0, x1.y * 0.5), "
    "vec4(vec2(x1.x, x1.y) * 0.015625, 1.0, x1.y * 0.5), vec4(vec2(x1.x, x1.y) * 0.0078125, 1.0, x1.y * 0.5))";
inline constexpr auto all_offsets = "mat4(x2, x3, x4, x5)", other_offsets = "mat4(x5, x4, x3, x2)";
inline constexpr auto rest =
    "vec4(0.25, -0.5, 0.125, 0.0), vec4(0.125, x0.w, 0.0, 0.0), vec4(64.0, 48.0, 2.0, 0.0) * x1.z, vec3(x0.x, x0.y, "
    "x0.z)";

[[nodiscard]] inline glm::mat4 farther_scales(const sample& s) {
    glm::mat4 farther = scales(s);
    for (glm::length_t i = 0; i < 4; ++i) farther[i] *= vec4(0.0625f, 0.0625f, 1.0f, 1.0f);
    return farther;
}
[[nodiscard]] inline glm::mat4 offsets(const sample& s) { return {s.x[2], s.x[3], s.x[4], s.x[5]}; }
[[nodiscard]] inline glm::mat4 farther_offsets(const sample& s) { return {s.x[5], s.x[4], s.x[3], s.x[2]}; }

/// large_values but those millions of units away, where no cascade is: there sums round by more than an ulp of a place.
[[nodiscard]] inline std::vector<value_class> values_in_reach() {
    auto kinds = large_values();
    std::erase_if(kinds, [](const value_class& kind) { return kind.name == "out of range"; });
    return kinds;
}

/// nested(), with the number of a cascade in x5.w, up to one after the last of `count`.
[[nodiscard]] inline std::vector<input_class> numbered(std::uint32_t count,
                                                       const std::vector<value_class>& kinds = values_in_reach()) {
    auto classes = nested(kinds);
    for (input_class& c : classes)
        c.fill = [fill = c.fill, count](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            s.x[0].w = static_cast<float>(r.below(count));
            s.x[5].w = static_cast<float>(r.below(count + 1));
            if (count > 4 && r.below(2) == 0) s.x[0].x *= 8.0f;
        };
    return classes;
}

}  // namespace parity::cascades
