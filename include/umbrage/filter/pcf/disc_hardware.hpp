// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) over a disc by a comparison sampler: each point is one fetch that compares and
// weights four texels.
//
//     float visibility = umbrage::disc_hardware<16>(umbrage::bordered(map), coord, depth - bias, 3.0f,
//                                                   umbrage::disc_rotation(pixel));
//
// Maps and samplers as for pcf_2x2_hardware.hpp. Points are not rounded to texels, since the sampler weights its texels
// in any case. So a point costs little more than its fetch.
// See also: disc.hpp, exact on every GPU.
#pragma once

#include <string>

#include <glm/common.hpp>

#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>

namespace umbrage {

/// Radius of a disc in texels, as the hardware versions take it: clamped to [0, 255.9375], 0 for NaN.
template <real T>
[[nodiscard]] constexpr T clamped_disc_radius(T radius) {
    return radius > T(0) ? (glm::min)(radius, T(max_disc_radius)) : T(0);
}
/// Both radii of an ellipse.
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> clamped_disc_radius(glm::vec<2, T> radius) {
    return {clamped_disc_radius(radius.x), clamped_disc_radius(radius.y)};
}

/// Position of a point of a disc or an ellipse, in texels.
/// @param coord      center of the disc, in texels
/// @param p          one of disc_points, in 1/16 of the radius
/// @param rotation   from disc_rotation
/// @param radius     along x and y, in texels
/// @formula          coord + rotated point * radius / 1024, where the rotated point is the rotation's rows times p
template <real T>
[[nodiscard]] glm::vec<2, T> disc_position(glm::vec<2, T> coord, glm::vec<2, T> p, glm::vec<4, T> rotation,
                                           glm::vec<2, T> radius) {
    const glm::vec<2, T> part = radius * T(1.0 / 1024.0);
    const glm::vec<2, T> x = glm::vec<2, T>(rotation.x, rotation.z) * part,
                         y = glm::vec<2, T>(rotation.y, rotation.w) * part;
    return coord + x * p.x + y * p.y;
}

/// Mean of pcf_2x2 over the points of an ellipse. Where texels are not square, a disc in the world is such an ellipse.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called 4 Points times, with indices up to
///                   a radius and one texel outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param radius     along x and y, in texels; clamped to 0 .. 255.9375, NaN is 0
/// @param rotation   from disc_rotation. Trades banding for noise
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0
/// @formula          mean of pcf_2x2(disc_position) over disc_points
/// @exactness        C, within 1/128 as pcf_2x2_hardware: the error of a mean is at most that of its parts
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T ellipse_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> radius,
                                 glm::vec<4, T> rotation, Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> rho = clamped_disc_radius(radius);
    T sum = T(0);
    for (const glm::ivec2 point : disc_points<Points>)
        sum += lit_filtered(fetch, disc_position(coord, glm::vec<2, T>(point), rotation, rho), receiver, is_lit);
    return sum * T(1.0 / Points);
}

/// Mean of pcf_2x2 over the points of a disc.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called 4 Points times, with indices up to
///                   a radius and one texel outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param radius     in texels; clamped to 0 .. 255.9375, NaN is 0
/// @param rotation   from disc_rotation. Trades banding for noise
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0
/// @formula          mean of pcf_2x2(disc_position) over disc_points
/// @exactness        C, within 1/128 as pcf_2x2_hardware: the error of a mean is at most that of its parts
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T disc_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T radius, glm::vec<4, T> rotation,
                              Compare is_lit = {}) {
    return ellipse_hardware<Points>(fetch, coord, receiver, glm::vec<2, T>(radius), rotation, is_lit);
}

namespace glsl {

namespace detail {

/// First lines of every shader text over an ellipse in uv, from its function's opening brace on.
inline constexpr const char* disc_in_uv = R"GLSL(
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    UMBRAGE_HIGHP float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    UMBRAGE_HIGHP vec2 part = vec2(wide, high) * (1.0 / 1024.0) / size;
    UMBRAGE_HIGHP vec2 x = vec2(rotation.x, rotation.z) * part;
    UMBRAGE_HIGHP vec2 y = vec2(rotation.y, rotation.w) * part;
)GLSL";

/// Appends a point's position in uv to the text: center + x $x + y $y.
inline void append_point(std::string& text, disc_point p, const char* before, const char* after) {
    text += before;
    append(text, "center $s x * $x.0 $t y * $y.0",
           {{'s', 0, p.x < 0 ? "-" : "+"},
            {'x', p.x < 0 ? -p.x : p.x},
            {'t', 0, p.y < 0 ? "-" : "+"},
            {'y', p.y < 0 ? -p.y : p.y}});
    text += after;
}

[[nodiscard]] inline std::string ellipse_hardware_text(int points) {
    std::string text = filled(R"GLSL(
// umbrage_ellipse_hardware$n: PCF over $n points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_ellipse_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                               UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 radius,
                                               UMBRAGE_HIGHP vec4 rotation) {)GLSL",
                              {{'n', points}});
    text += disc_in_uv;
    text += "    UMBRAGE_HIGHP float n = 0.0;\n";
    for (const disc_point p : umbrage::detail::points_of_disc(points))
        append_point(text, p, "    n += umbrage_lit_at(map, size, ", ", coord, receiver);\n");
    append(text,
           R"GLSL(    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / $n.0) : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL",
           {{'n', points}});
    return text;
}

[[nodiscard]] inline std::string disc_hardware_text(int points) {
    return filled(R"GLSL(
// umbrage_disc_hardware$n: PCF over $n points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP vec4 rotation) {
    return umbrage_ellipse_hardware$n(map, size, coord, receiver, vec2(radius, radius), rotation);
}
)GLSL",
                  {{'n', points}});
}

}  // namespace detail

template <int Points>
inline constexpr snippet ellipse_hardware{
    .name = Points == 8 ? "ellipse_hardware8" : (Points == 16 ? "ellipse_hardware16" : "ellipse_hardware32"),
    .summary = Points == 8    ? "PCF over an ellipse, 8 fetches from a linear comparison sampler"
               : Points == 16 ? "PCF over an ellipse, 16 fetches from a linear comparison sampler"
                              : "PCF over an ellipse, 32 fetches from a linear comparison sampler",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&in_filter_domain, &within_far_plane, &lit_at>,
    .source = {detail::ellipse_hardware_text, Points}};

template <int Points>
inline constexpr snippet disc_hardware{
    .name = Points == 8 ? "disc_hardware8" : (Points == 16 ? "disc_hardware16" : "disc_hardware32"),
    .summary = Points == 8    ? "disc PCF, 8 fetches from a linear comparison sampler"
               : Points == 16 ? "disc PCF, 16 fetches from a linear comparison sampler"
                              : "disc PCF, 32 fetches from a linear comparison sampler",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&ellipse_hardware<Points>>,
    .source = {detail::disc_hardware_text, Points}};

inline constexpr const snippet* disc_hardware_snippets[]{
    &lit_at,           &ellipse_hardware<8>, &ellipse_hardware<16>, &ellipse_hardware<32>,
    &disc_hardware<8>, &disc_hardware<16>,   &disc_hardware<32>};

}  // namespace glsl
}  // namespace umbrage
