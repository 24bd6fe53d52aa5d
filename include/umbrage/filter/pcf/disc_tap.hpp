// SPDX-License-Identifier: MIT
//
// Points of a disc, and the texels that they fall on: 8, 16 or 32 points, rotated per pixel to hide the pattern.
//
//     const glm::vec4 rotation = umbrage::disc_rotation(pixel);
//     const glm::vec2 radius(umbrage::disc_radius(3.0f));
//     for (const glm::ivec2 point : umbrage::disc_points<16>)
//         use(umbrage::disc_tap(glm::floor(coord * 256.0f), glm::vec2(point), rotation, radius));
//
// Points, rotations and radii are integers, so the taps fall on the same texels everywhere. The points were annealed
// for the smallest error on edges of any direction, alone and over four rotations by 90 degrees.
// See also: disc.hpp, blocker/penumbra.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/core/texel_space.hpp>

namespace umbrage {

/// Largest radius of a disc, in texels.
inline constexpr float max_disc_radius = 4095.0f / 16.0f;

/// Point of a disc, in 1/16 of its radius.
struct disc_point {
    int x, y;
    [[nodiscard]] operator glm::ivec2() const { return {x, y}; }
};

/// Points of a disc, in 1/16 of its radius.
template <int Points>
requires(Points == 8 || Points == 16 ||
         Points == 32) inline constexpr std::array<disc_point, std::size_t(Points)> disc_points{};
template <>
inline constexpr std::array<disc_point, 8> disc_points<8>{
    {{3, -1}, {-4, 5}, {1, -11}, {-9, -8}, {-12, 3}, {11, 6}, {0, 13}, {11, -7}}};
// The formatter would give each of these points a line of its own.
// clang-format off
template <>
inline constexpr std::array<disc_point, 16> disc_points<16>{
    {{1, -3}, {5, 2}, {-5, 2}, {0, 7}, {-6, -5}, {8, -5}, {0, -11}, {11, 5}, {-12, 4}, {-1, 13}, {7, 11},
     {-9, 10}, {-13, -4}, {7, -12}, {-7, -12}, {14, -2}}};
// clang-format on
template <>
inline constexpr std::array<disc_point, 32> disc_points<32>{
    {{-2, -1}, {3, 2},    {1, -4},  {-4, 3},   {0, 6},   {-5, -5},  {7, -2},  {-8, -1}, {8, 3},    {5, 7},  {1, -9},
     {6, -7},  {-8, 5},   {0, 10},  {-3, -10}, {-6, 10}, {-9, -8},  {11, -5}, {5, -12}, {-13, -1}, {7, 11}, {13, 3},
     {-13, 4}, {10, -10}, {14, -2}, {-11, 9},  {3, 14},  {-13, -6}, {12, 8},  {-4, 14}, {-7, -13}, {0, -15}}};

namespace detail {

/// Points of a disc whose number is known only at run time. A number other than 8 and 16 counts as 32.
[[nodiscard]] constexpr std::span<const disc_point> points_of_disc(int points) {
    if (points == 8) return disc_points<8>;
    if (points == 16) return disc_points<16>;
    return disc_points<32>;
}

/// Rotation from disc_rotation or sheared_rotation, whose components are at most 576. Any other, NaN included: the
/// first one of disc_rotation.
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> bounded_rotation(glm::vec<4, T> rotation) {
    const bool bounded = inside_texel_space(glm::vec<2, T>(rotation.x, rotation.y) * T(56)) &&
                         inside_texel_space(glm::vec<2, T>(rotation.z, rotation.w) * T(56));
    return bounded ? rotation : glm::vec<4, T>(T(64), T(0), T(0), T(64));
}

/// Radii of an ellipse, clamped to -4095 .. 4095; NaN is 0. With a rotation of disc_rotation all taps then lie within
/// max_disc_radius.
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> bounded_radius(glm::vec<2, T> radius) {
    const auto bounded = [](T r) { return is_nan(r) ? T(0) : (glm::clamp)(r, T(-4095), T(4095)); };
    return {bounded(radius.x), bounded(radius.y)};
}

}  // namespace detail

/// Rotation of the disc for a pixel: one of 16, each used once in every 4 x 4 pixels.
/// @param pixel      pixel position, in pixels; fractions are dropped
/// @return           (cos, -sin, sin, cos) in 1/64, the rows of a matrix: integers, each row of length 63.6 to 64
/// @edge             |x| or |y| >= 2^15, or NaN: the first rotation, (64, 0, 0, 64)
/// @formula          v = 4x + y mod 16; rotates by floor(v / 4) quarter turns and (v mod 4) times 22.5 degrees
/// @exactness        A
template <real T>
[[nodiscard]] glm::vec<4, T> disc_rotation(glm::vec<2, T> pixel) {
    const auto turned = [](T c, T s) { return glm::vec<4, T>(c, T(0) - s, s, c); };
    if (!inside_texel_space(pixel)) return turned(T(64), T(0));
    const glm::vec<2, T> whole = glm::floor(pixel);
    const T sum = whole.x * T(4) + whole.y;
    const auto v = static_cast<int>(sum - glm::floor(sum * T(1.0 / 16.0)) * T(16));
    constexpr int base[4][2]{{64, 0}, {59, 24}, {45, 45}, {24, 59}};
    const T c = T(base[v % 4][0]), s = T(base[v % 4][1]);
    switch (v / 4) {
        case 0: return turned(c, s);
        case 1: return turned(T(0) - s, c);
        case 2: return turned(T(0) - c, T(0) - s);
        default: return turned(s, T(0) - c);
    }
}

/// Rotation of a disc, and then a shear along x. It is for maps whose texels are no rectangles of the world.
/// @param rotation   from disc_rotation
/// @param shear      by how much x grows with y, both in radii of the ellipse; -8 to 8
/// @return           rows (x, y) + shear (z, w) and (z, w)
/// @exactness        B, n = 2
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> sheared_rotation(glm::vec<4, T> rotation, T shear) {
    return {rotation.x + shear * rotation.z, rotation.y + shear * rotation.w, rotation.z, rotation.w};
}

/// Texel that a point of a disc falls on.
/// @param position   floor(256 coord) of the receiver, in 1/256 texel
/// @param p          one of disc_points, in 1/16 of the radius
/// @param rotation   from disc_rotation or sheared_rotation
/// @param radius     along x and y, in 1/16 texel, integers from 0 to 4095
/// @return           index of the texel
/// @formula          floor((position + rotated point * radius / 64) / 256), where the rotated point is the rotation's
///                   rows times p
/// @exactness        A for a rotation of disc_rotation: multiples of 2^-14 below 2^10, in any order
template <real T>
[[nodiscard]] glm::vec<2, T> disc_tap(glm::vec<2, T> position, glm::vec<2, T> p, glm::vec<4, T> rotation,
                                      glm::vec<2, T> radius) {
    const glm::vec<2, T> at = position * T(1.0 / 256.0), texel = glm::floor(at);
    const glm::vec<2, T> within = glm::clamp(at - texel, T(0), T(1));  // no sum is regrouped across the clamp
    const glm::vec<2, T> wide = glm::vec<2, T>(rotation.x, rotation.y) * (radius.x * T(1.0 / 16384.0)),
                         high = glm::vec<2, T>(rotation.z, rotation.w) * (radius.y * T(1.0 / 16384.0));
    return texel + glm::floor(within + glm::vec<2, T>(wide.x * p.x + wide.y * p.y, high.x * p.x + high.y * p.y));
}

/// Radius of a disc in 1/16 texel, from one in texels: floor(16 radius), at most 4095. Negative or NaN: 0.
/// @exactness        A
template <real T>
[[nodiscard]] constexpr T disc_radius(T radius) {
    if (is_nan(radius) || !(radius > T(0))) return T(0);
    return radius < T(255.9375) ? T(static_cast<int>(radius * T(16))) : T(4095);
}

namespace glsl {

inline constexpr snippet disc_rotation{
    .name = "disc_rotation",
    .summary = "rotation of a disc for a pixel, one of 16",
    .exactness = tier::a,
    .needs = list<&inside_texel_space>,
    .source = R"GLSL(
// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, -sin, sin, cos) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
UMBRAGE_HIGHP vec4 umbrage_disc_rotation(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float v = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    UMBRAGE_HIGHP float quarter = floor(v * 0.25);
    UMBRAGE_HIGHP float base = v - quarter * 4.0;
    UMBRAGE_HIGHP vec2 low = base < 0.5 ? vec2(64.0, 0.0) : vec2(59.0, 24.0);
    UMBRAGE_HIGHP vec2 high = base < 2.5 ? vec2(45.0, 45.0) : vec2(24.0, 59.0);
    UMBRAGE_HIGHP vec2 first = base < 1.5 ? low : high;
    UMBRAGE_HIGHP vec2 once = quarter < 0.5 ? first : vec2(0.0 - first.y, first.x);
    UMBRAGE_HIGHP vec2 twice = quarter < 2.5 ? vec2(0.0 - first.x, 0.0 - first.y) : vec2(first.y, 0.0 - first.x);
    UMBRAGE_HIGHP vec2 turned = quarter < 1.5 ? once : twice;
    return vec4(turned.x, 0.0 - turned.y, turned.y, turned.x);
}
)GLSL",
};

inline constexpr snippet sheared_rotation{
    .name = "sheared_rotation",
    .summary = "rotation of a disc, sheared to an ellipse",
    .exactness = tier::b,
    .operations = 2,
    .source = R"GLSL(
// umbrage_sheared_rotation: rotation of a disc, and then a shear along x
//   rotation   from umbrage_disc_rotation
//   shear      by how much x grows with y, both in radii of the ellipse; -2.0 to 2.0
UMBRAGE_HIGHP vec4 umbrage_sheared_rotation(UMBRAGE_HIGHP vec4 rotation, UMBRAGE_HIGHP float shear) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = rotation.x + shear * rotation.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = rotation.y + shear * rotation.w;
    return vec4(x, y, rotation.z, rotation.w);
}
)GLSL",
};

inline constexpr snippet disc_tap{
    .name = "disc_tap",
    .summary = "texel that a point of a disc falls on",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     along x and y, in 1/16 texel, integers from 0 to 4095
UMBRAGE_HIGHP vec2 umbrage_disc_tap(UMBRAGE_HIGHP vec2 position, UMBRAGE_HIGHP vec2 p, UMBRAGE_HIGHP vec4 rotation,
                                    UMBRAGE_HIGHP vec2 radius) {
    UMBRAGE_HIGHP vec2 at = position * (1.0 / 256.0);
    UMBRAGE_HIGHP vec2 texel = floor(at);
    UMBRAGE_HIGHP vec2 within = clamp(at - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));  // no sum is regrouped across it
    UMBRAGE_HIGHP vec2 wide = vec2(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    UMBRAGE_HIGHP vec2 high = vec2(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    UMBRAGE_HIGHP float x = wide.x * p.x + within.x + wide.y * p.y;
    UMBRAGE_HIGHP float y = high.x * p.x + within.y + high.y * p.y;
    return texel + floor(vec2(x, y));
}
)GLSL",
};

inline constexpr snippet disc_radius{
    .name = "disc_radius",
    .summary = "radius of a disc, rounded down to 1/16 texel",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
UMBRAGE_HIGHP float umbrage_disc_radius(UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
)GLSL",
};

inline constexpr const snippet* disc_tap_snippets[]{&disc_rotation, &sheared_rotation, &disc_tap, &disc_radius};

}  // namespace glsl
}  // namespace umbrage
