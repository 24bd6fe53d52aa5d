// SPDX-License-Identifier: MIT
//
// Receiver plane depth bias: each texel is compared with the depth of the receiver's plane at the texel's center.
// So a filter of any reach needs no bias. The slope comes from plane_slope or from screen-space derivatives.
//
//     glm::vec2 slope = umbrage::plane_slope(plane_matrix, normal, world);
//     float visibility = filter(umbrage::apply_receiver_plane(fetch, slope, coord), coord, p.z - rounding);
//
// In a shader bind the filter with {.receiver_plane = true}. It then takes slope and coord after the map.
// Also called: receiver plane bias, RPDB (receiver_plane_slope, apply_receiver_plane).
// See also: acne_free.hpp, one bias for the whole kernel.
#pragma once

#include <concepts>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Slope of the plane through a receiver and its neighbors on the screen.
///
/// @param dx       derivative of (x and y in texels, depth) along the screen's x: dFdx, taken outside of branches
/// @param dy       the same along the screen's y: dFdy
/// @return         x, y: change of depth per texel, as from plane_slope. z: largest error of their sum. It is the bias
///                 that is left to add per texel of reach: acne_free_bias({z, 0}, reach, error)
/// @edge           NaN, a pixel whose texels are nearly in line, or fewer than 2^-10 texels per pixel: (0, 0, 0). The
///                 slope is then unknown, and the plane counts as facing the light
/// @formula        Cramer's rule; z = 3.3 (2^-25 + (|x| + |y|) 2^-13) s / |determinant|, for coordinates below 4096.
///                 s is the sum of the four magnitudes. s / |determinant| bounds 1 / the smallest number of texels per
///                 pixel
/// @exactness      C, n = 31: divisions. S of x = (|dy.y dx.z| + |dx.y dy.z|) d / determinant^2, of y likewise, of z =
///                 3.3 (2^-25 + (S(x) + S(y)) 2^-13) s d / determinant^2, d = |dx.x dy.y| + |dx.y dy.x|
/// @cite           Isidoro: Shadow Mapping, Tricks and Techniques, GDC 2006
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> receiver_plane_slope(glm::vec<3, T> dx, glm::vec<3, T> dy) {
    const auto magnitude = [](T v) { return v < T(0) ? -v : v; };
    const T determinant = dx.x * dy.y + dx.y * -dy.x;
    const T sum = magnitude(dx.x) + magnitude(dx.y) + magnitude(dy.x) + magnitude(dy.y);
    const T a = clamp_slope((dy.y * dx.z + dx.y * -dy.z) / determinant);
    const T b = clamp_slope((dx.x * dy.z + dy.x * -dx.z) / determinant);
    const T off = (T(0x1p-25) + (magnitude(a) + magnitude(b)) * T(0x1p-13)) * T(3.3);
    const T least = sum * T(0x1p-10);
    const bool known = !is_nan(determinant) && !is_nan(sum) && magnitude(determinant) > least && sum < T(0x1p64);
    if (!known) return glm::vec<3, T>(0);
    return {a, b, clamp_slope(off * (sum / magnitude(determinant)))};
}

/// Stored depth, moved along the receiver's plane from its texel to the receiver.
///
/// @param stored   depth from the map
/// @param slope    slope of the receiver's plane, depth per texel, -2 to 2
/// @param coord    receiver position in the map, in texels
/// @param texel    index of the stored depth's texel
/// @param cleared  depth of the far plane: 1, or 0 for reversed depth
/// @return         depth to compare with the receiver
/// @edge           stored depth within 2^-64 of cleared: unchanged
/// @formula        stored - slope . (texel + 1/2 - coord)
/// @exactness      B, n = 8
template <real T>
[[nodiscard]] constexpr T apply_receiver_plane(T stored, glm::vec<2, T> slope, glm::vec<2, T> coord,
                                               glm::vec<2, T> texel, T cleared = T(1)) {
    const T x = texel.x + T(0.5) - coord.x, y = texel.y + T(0.5) - coord.y;
    const T before = stored - cleared;
    const bool is_cleared = before < T(0x1p-64) && before > T(-0x1p-64);
    return is_cleared ? stored : stored - (slope.x * x + slope.y * y);
}

/// Fetch callable that applies the receiver's plane to every texel.
/// @param fetch       ivec2 texel -> stored depth
/// @param slope       change of depth per texel in x and y, from receiver_plane_slope
/// @param coord       position that the filter is called with, in texels
/// @param direction   depth direction of the map, which gives its cleared depth
template <std::invocable<glm::ivec2> Fetch>
[[nodiscard]] auto apply_receiver_plane(Fetch fetch, glm::vec2 slope, glm::vec2 coord,
                                        depth_direction direction = depth_direction::forward) {
    return [=, cleared = cleared_depth(direction)](glm::ivec2 texel) {
        return apply_receiver_plane(static_cast<float>(fetch(texel)), slope, coord, glm::vec2(texel), cleared);
    };
}

namespace glsl {

inline constexpr snippet receiver_plane_slope{
    .name = "receiver_plane_slope",
    .summary = "slope of a receiver's plane from derivatives, and its error",
    .exactness = tier::c,
    .operations = 31,
    .needs = list<&clamp_slope>,
    .source = R"GLSL(
// umbrage_receiver_plane_slope: change of a receiver's depth per texel in x and y, and the largest error of their sum
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); the result is zero where they do not give the plane
UMBRAGE_HIGHP vec3 umbrage_receiver_plane_slope(UMBRAGE_HIGHP vec3 dx, UMBRAGE_HIGHP vec3 dy) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float determinant = dx.x * dy.y + dx.y * -dy.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_x = dy.y * dx.z + dx.y * -dy.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_y = dx.x * dy.z + dy.x * -dx.z;
    UMBRAGE_HIGHP float a = umbrage_clamp_slope(along_x / determinant);
    UMBRAGE_HIGHP float b = umbrage_clamp_slope(along_y / determinant);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float off = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float error = off * (sum / abs(determinant));
    UMBRAGE_HIGHP float least = sum * (1.0 / 1024.0);
    bool known = abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? vec3(a, b, umbrage_clamp_slope(error)) : vec3(0.0, 0.0, 0.0);
}
)GLSL",
};

inline constexpr snippet apply_receiver_plane{
    .name = "apply_receiver_plane",
    .summary = "stored depth moved along the receiver's plane to it",
    .exactness = tier::b,
    .operations = 8,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_apply_receiver_plane: a texel's depth moved along the receiver's plane to the receiver; not if cleared
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   coord   receiver position, in texels
//   texel   index of the texel
UMBRAGE_HIGHP float umbrage_apply_receiver_plane(UMBRAGE_HIGHP float stored, UMBRAGE_HIGHP vec2 slope,
                                              UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 way = texel + 0.5 - coord;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = stored - (slope.x * way.x + slope.y * way.y);
    bool cleared = abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return cleared ? stored : depth;
}
)GLSL",
};

inline constexpr const snippet* receiver_plane_snippets[]{&receiver_plane_slope, &apply_receiver_plane};

}  // namespace glsl
}  // namespace umbrage
