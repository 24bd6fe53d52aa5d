// SPDX-License-Identifier: MIT
//
// Receiver plane depth bias: compares each texel with the receiver or with its plane at the texel's center, whichever
// is nearer to the light. So a filter of any reach needs half a texel of bias alone. The slope comes from `plane_slope`
// or from screen-space derivatives.
//
//     glm::vec2 slope = umbrage::plane_slope(plane_matrix, normal, world);
//     float receiver = p.z - umbrage::acne_free_bias(slope, 0.5f, error);
//     glm::vec3 at(coord, receiver);
//     float visibility = filter(umbrage::apply_receiver_plane(fetch, slope, at), coord, receiver);
//
// The plane alone would darken both sides of a concave edge, where it runs behind the other wall.
// In a shader bind the filter with {.receiver_plane = true}. It then takes slope and at after the map.
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
#include <umbrage/core/texel_space.hpp>

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

namespace detail {

/// The one of two depths that is nearer to the light; the receiver's where the plane's is NaN.
/// @param forward   true where depth grows away from the light
template <real T>
[[nodiscard]] constexpr T nearer_to_light(T receiver, T plane, bool forward) {
    return !is_nan(plane) && (forward ? plane < receiver : plane > receiver) ? plane : receiver;
}

}  // namespace detail

/// Depth that a texel is compared with: the receiver's, or its plane's at the texel where that is nearer to the light.
///
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param slope      slope of the receiver's plane, depth per texel, -2 to 2
/// @param coord      receiver position in the map, in texels
/// @param texel      index of the texel
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @edge             a NaN in any other argument than receiver: returns receiver. A shader may return NaN, which is in
///                   shadow; slopes of clamp_slope are never NaN. Below 2^-126 hardware may give either
/// @formula          min(receiver + slope . (texel - (coord - 1/2)), receiver); max for reversed depth
/// @exactness        B, n = 8
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T plane_reference(T receiver, glm::vec<2, T> slope, glm::vec<2, T> coord, glm::vec<2, T> texel,
                                          Compare is_lit = {}) {
    const T x = texel.x - (coord.x - T(0.5)), y = texel.y - (coord.y - T(0.5));
    return detail::nearer_to_light(receiver, (receiver + slope.x * x) + slope.y * y, is_lit(T(0), T(1)));
}

/// `plane_reference` in a map whose border is lit. Outside the map it is nearer to the light than every stored depth.
/// @param inside     texel if the map has it, otherwise any other
/// Other parameters as for plane_reference.
/// @formula          as plane_reference, but 2^24 towards the light in place of the product of each axis along which
///                   inside is not texel
/// @exactness        B, n = 8
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T bordered_plane_reference(T receiver, glm::vec<2, T> slope, glm::vec<2, T> coord,
                                                   glm::vec<2, T> texel, glm::vec<2, T> inside, Compare is_lit = {}) {
    const bool forward = is_lit(T(0), T(1));
    const T lights = forward ? T(-0x1p24) : T(0x1p24);
    const T x = inside.x == texel.x ? slope.x * (texel.x - (coord.x - T(0.5))) : lights;
    const T y = inside.y == texel.y ? slope.y * (texel.y - (coord.y - T(0.5))) : lights;
    return detail::nearer_to_light(receiver, (receiver + x) + y, forward);
}

/// Depth that four texels are compared with at once: the receiver's, or its plane's where they meet, if that is nearer
/// to the light. Each of them lies half a texel beside, along both axes.
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param slope      slope of the receiver's plane, depth per texel
/// @param way        from the receiver to where the texels meet, in texels
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @edge             a NaN in slope or way: returns receiver. A shader may return NaN
/// @formula          min(receiver + slope . way, receiver); max for reversed depth
/// @exactness        C, n = 5: a shader may fuse or reorder the sum
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T corner_reference(T receiver, glm::vec<2, T> slope, glm::vec<2, T> way, Compare is_lit = {}) {
    return detail::nearer_to_light(receiver, (receiver + slope.x * way.x) + slope.y * way.y, is_lit(T(0), T(1)));
}

/// Fetch callable that compares every texel along the receiver's plane. A lit texel has the depth of the far plane. Any
/// other has its own. A filter's own comparison then decides alike, and a search finds depths as stored.
/// @param fetch       ivec2 texel -> stored depth
/// @param slope       change of depth per texel in x and y, from receiver_plane_slope
/// @param at          position that the filter is called with, in texels, and the receiver that it gets
/// @param direction   depth direction of the map, which gives its cleared depth
/// @exactness         B, n = 8: a comparison with plane_reference
template <std::invocable<glm::ivec2> Fetch>
[[nodiscard]] auto apply_receiver_plane(Fetch fetch, glm::vec2 slope, glm::vec3 at,
                                        depth_direction direction = depth_direction::forward) {
    return [=, is_lit = comparison{direction}](glm::ivec2 texel) {
        const auto stored = static_cast<float>(fetch(texel));
        const float reference = plane_reference(at.z, slope, glm::vec2(at), glm::vec2(texel), is_lit);
        return is_lit(reference, stored) ? cleared_depth(direction) : stored;
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

inline constexpr snippet plane_reference{
    .name = "plane_reference",
    .summary = "depth that a texel is compared with, by the receiver's plane",
    .exactness = tier::b,
    .operations = 8,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_plane_reference: depth of the receiver, or of its plane at a texel where that is nearer to the light
//   slope   slope of the receiver's plane, per texel, no NaN
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
UMBRAGE_HIGHP float umbrage_plane_reference(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec3 at,
                                            UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 way = texel - (vec2(at.x, at.y) - 0.5);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = (at.z + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, at.z) : max(plane, at.z);
}
)GLSL",
};

inline constexpr snippet bordered_plane_reference{
    .name = "bordered_plane_reference",
    .summary = "plane_reference in a map whose border is lit",
    .exactness = tier::b,
    .operations = 8,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_bordered_plane_reference: umbrage_plane_reference, but before every stored depth outside the map
//   slope, at, texel   as for umbrage_plane_reference
//   inside             texel if the map has it, otherwise any other
UMBRAGE_HIGHP float umbrage_bordered_plane_reference(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec3 at,
                                                     UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP vec2 inside) {
    UMBRAGE_HIGHP float lights = umbrage_cleared_depth() > 0.5 ? -16777216.0 : 16777216.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 moves = slope * (texel - (vec2(at.x, at.y) - 0.5));
    UMBRAGE_HIGHP float x = inside.x == texel.x ? moves.x : lights;  // the same for all texels of a column
    UMBRAGE_HIGHP float y = inside.y == texel.y ? moves.y : lights;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = (at.z + x) + y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, at.z) : max(plane, at.z);
}
)GLSL",
};

inline constexpr snippet corner_reference{
    .name = "corner_reference",
    .summary = "depth that four texels are compared with, by the receiver's plane",
    .exactness = tier::c,
    .operations = 5,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_corner_reference: depth of the receiver, or of its plane where four texels meet, the nearer to the light
//   slope      slope of the receiver's plane, per texel, no NaN
//   way        from the receiver to where the texels meet, in texels
//   receiver   depth, bias applied
UMBRAGE_HIGHP float umbrage_corner_reference(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec2 way,
                                             UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float plane = (receiver + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, receiver) : max(plane, receiver);
}
)GLSL",
};

inline constexpr snippet apply_receiver_plane{
    .name = "apply_receiver_plane",
    .summary = "stored depth, or the far plane's if lit along the receiver's plane",
    .exactness = tier::b,
    .operations = 8,
    .needs = list<&cleared_depth, &compare, &plane_reference>,
    .source = R"GLSL(
// umbrage_apply_receiver_plane: depth of a texel that shadows the receiver's plane; any other has the far plane's
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
UMBRAGE_HIGHP float umbrage_apply_receiver_plane(UMBRAGE_HIGHP float stored, UMBRAGE_HIGHP vec2 slope,
                                                 UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP float lit = umbrage_compare(umbrage_plane_reference(slope, at, texel), stored);
    return lit > 0.5 ? umbrage_cleared_depth() : stored;
}
)GLSL",
};

inline constexpr const snippet* receiver_plane_snippets[]{
    &receiver_plane_slope, &plane_reference, &bordered_plane_reference, &corner_reference, &apply_receiver_plane};

}  // namespace glsl
}  // namespace umbrage
