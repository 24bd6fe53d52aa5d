// SPDX-License-Identifier: MIT
//
// Debug view of a receiver's lookup: the texels of its map, or a plain color for the reason why it has no shadow.
//
//     glm::vec3 color = umbrage::probe_color(at, glm::vec2(1024), bias, 0.0f);
//     color = umbrage::probe_inputs(color, world, normal);
//
// Also called: shadow debug mode, cascade colors (probe_color).
// See also: shadow/probe.hpp, which joins both functions for a shadow, in C++ and in shaders.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

namespace detail {

/// True if a probe can use a number: not NaN, and of a magnitude below 2^64.
template <real T>
[[nodiscard]] constexpr bool is_usable(T v) {
    return !is_nan(v) && v < T(0x1p64) && v > T(-0x1p64);
}

}  // namespace detail

/// Debug color of a receiver's position in a map.
///
/// @param at          position in the map: x and y in texels, z depth before the bias
/// @param size        size of the map, in texels
/// @param bias        bias of the receiver, in depth
/// @param number      index of the map, an integer from 0 to 65535: a cascade, a face or a page
/// @param direction   depth direction of the map
/// @return            RGB in [0, 1]. All is well: squares of one texel, gray in map 0 and in the map's own color in the
///                    next seven, again gray in map 8.
///                    Magenta: not a number. Black: behind the light. White: outside the map, or all cascades.
///                    Cyan: beyond the far plane. Blue: in front of the near plane.
///                    Red: bias at its limit of 1, which removes all shadows
/// @formula           bits of number choose 0.875 or 0.375 for red, green and blue. Every other square is times 0.75
/// @exactness         A
template <real T>
[[nodiscard]] glm::vec<3, T> probe_color(glm::vec<3, T> at, glm::vec<2, T> size, T bias, T number,
                                         depth_direction direction = depth_direction::forward) {
    using color = glm::vec<3, T>;
    const T z_far = T(cleared_depth(direction)), z_near = T(1) - z_far;
    if (!(detail::is_usable(at.x) && detail::is_usable(at.y) && detail::is_usable(at.z))) return color(1, 0, 1);
    if (at.x >= T(65536)) return color(0, 0, 0);
    if (!(at.x >= T(0) && at.y >= T(0) && at.x <= size.x && at.y <= size.y)) return color(1, 1, 1);
    if (z_far > z_near ? at.z > T(1) : at.z < T(0)) return color(0, 1, 1);
    if (z_far > z_near ? at.z < T(0) : at.z > T(1)) return color(0, 0, 1);
    if (is_nan(bias) || !(bias < T(1))) return color(1, 0, 0);
    const auto is_odd = [](T v) { return v - T(2) * std::floor(v * T(0.5)) > T(0.5); };
    const T shade = is_odd(std::floor(at.x) + std::floor(at.y)) ? T(0.75) : T(1);
    const auto level = [&](T bit) { return (is_odd(std::floor(number * bit)) ? T(0.875) : T(0.375)) * shade; };
    return {level(T(1)), level(T(0.5)), level(T(0.25))};
}

/// The color given, unless the receiver itself is wrong.
///
/// @param color    color from probe_color
/// @param world    world position of the receiver
/// @param normal   surface normal of the receiver
/// @return         color, or yellow for a zero normal, which gets no bias
/// @edge           a component that is NaN or of magnitude 2^64 or more: magenta
/// @exactness      A
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> probe_inputs(glm::vec<3, T> color, glm::vec<3, T> world, glm::vec<3, T> normal) {
    bool usable = true, zero = true;
    for (glm::length_t i = 0; i < 3; ++i) {
        usable = usable && detail::is_usable(world[i]) && detail::is_usable(normal[i]);
        zero = zero && normal[i] == T(0);
    }
    if (!usable) return {T(1), T(0), T(1)};
    return zero ? glm::vec<3, T>(T(1), T(1), T(0)) : color;
}

namespace glsl {

inline constexpr snippet probe_color{
    .name = "probe_color",
    .summary = "debug color of a lookup: its texels, or why it fails",
    .exactness = tier::a,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_probe_color: debug color of a receiver's position in a map
//   at      x and y in texels, z depth
//   size    size of the map, in texels
//   bias    bias of the receiver, in depth
//   number  index of the map, an integer
//   magenta  not a number
//   black    behind the light
//   white    outside the map, or all cascades
//   cyan     beyond the far plane
//   blue     in front of the near plane
//   red      bias at its limit of 1.0
//   else     squares of one texel, gray or in the map's color: all is well
UMBRAGE_HIGHP vec3 umbrage_probe_color(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float bias,
                                       UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = abs(at.x) < limit && abs(at.y) * 2.0 < limit * 2.0 && abs(at.z) * 4.0 < limit * 4.0;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    UMBRAGE_HIGHP vec2 place = clamp(vec2(at.x, at.y), vec2(0.0, 0.0), vec2(65536.0, 65536.0));
    UMBRAGE_HIGHP float square = floor(place.x) + floor(place.y);
    UMBRAGE_HIGHP float shade = square - 2.0 * floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    UMBRAGE_HIGHP vec3 bits = floor(vec3(number, number * 0.5, number * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    UMBRAGE_HIGHP vec3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : vec3(1.0, 0.0, 0.0);
    color = past_near ? vec3(0.0, 0.0, 1.0) : color;
    color = past_far ? vec3(0.0, 1.0, 1.0) : color;
    color = inside ? color : vec3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : vec3(0.0, 0.0, 0.0);
    return usable ? color : vec3(1.0, 0.0, 1.0);
}
)GLSL",
};

inline constexpr snippet probe_inputs{
    .name = "probe_inputs",
    .summary = "debug color, unless position or normal is wrong",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_probe_inputs: color, unless the receiver is wrong
//   magenta  position or normal is not a number
//   yellow   a normal of zero
UMBRAGE_HIGHP vec3 umbrage_probe_inputs(UMBRAGE_HIGHP vec3 color, UMBRAGE_HIGHP vec3 world,
                                        UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = abs(world.x) < limit && abs(world.y) * 2.0 < limit * 2.0 && abs(world.z) * 4.0 < limit * 4.0;
    usable = usable && abs(normal.x) * 8.0 < limit * 8.0;
    usable = usable && abs(normal.y) * 16.0 < limit * 16.0 && abs(normal.z) * 32.0 < limit * 32.0;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    UMBRAGE_HIGHP vec3 given = zero ? vec3(1.0, 1.0, 0.0) : color;
    return usable ? given : vec3(1.0, 0.0, 1.0);
}
)GLSL",
};

inline constexpr const snippet* probe_color_snippets[]{&probe_color, &probe_inputs};

}  // namespace glsl
}  // namespace umbrage
