// SPDX-License-Identifier: MIT
//
// A disc by the sampler: each point is a look-up that compares four texels and weighs them.
//
//     float visibility = umbrage::disc_hardware<16>(umbrage::bordered(map), coord, depth - bias, 3.0f,
//                                                   umbrage::disc_rotation(pixel));
//
// Maps and samplers are as for pcf_2x2_hardware.hpp. Points lie where they fall, between texels, as the sampler weighs
// them anyway: nothing is rounded, so that a point costs little more than its look-up.
#pragma once

#include <string>

#include <umbrage/core/lesser.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>

namespace umbrage {

/// A disc's radius as hardware forms take it: clamped to [0, 255.9375], 0 for NaN.
template <real T>
[[nodiscard]] constexpr T clamped_disc_radius(T radius) {
    return radius > T(0) ? detail::lesser(radius, T(max_disc_radius)) : T(0);
}

/// Where a point of a disc lies.
/// @param coord    the disc's middle, in texels
/// @param p        one of disc_points;   rotation  as disc_rotation gives it
/// @param radius   in texels
/// @formula        coord + turned point * radius / 1024, of point (x, y) turned by (c, s): (c x - s y, s x + c y)
template <real T>
[[nodiscard]] glm::vec<2, T> disc_position(glm::vec<2, T> coord, glm::vec<2, T> p, glm::vec<2, T> rotation, T radius) {
    const glm::vec<2, T> scaled = rotation * (radius * T(1.0 / 1024.0));
    return coord + glm::vec<2, T>(scaled.x * p.x - scaled.y * p.y, scaled.y * p.x + scaled.x * p.y);
}

/// Mean of pcf_2x2 over a disc's points.
/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called 4 Points times, texels may lie a radius and one outside
/// @param coord      receiver in texels, the first texel's center is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param radius     in texels; clamped to 0 .. 255.9375, NaN is 0
/// @param rotation   as disc_rotation gives it
/// @return           visibility, 0 in shadow, 1 lit
/// @formula          mean of pcf_2x2(disc_position) over disc_points
/// @exactness        C, within 1/128 as pcf_2x2_hardware: the mean is off by no more than each of its parts
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T disc_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T radius, glm::vec<2, T> rotation,
                              Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const T rho = clamped_disc_radius(radius);
    T sum = T(0);
    for (const glm::ivec2 point : disc_points<Points>)
        sum += lit_filtered(fetch, disc_position(coord, glm::vec<2, T>(point), rotation, rho), receiver, is_lit);
    return sum * T(1.0 / Points);
}

namespace glsl {

namespace detail {

/// What every text over a disc's points in uv begins with, from its head's closing brace on.
inline constexpr const char* disc_in_uv = R"GLSL(
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
)GLSL";

/// `text` with the point's place in uv: center + x $x + y $y.
inline void append_point(std::string& text, disc_point p, const char* before, const char* after) {
    text += before;
    append(text, "center $s x * $x.0 $t y * $y.0",
           {{'s', 0, p.x < 0 ? "-" : "+"},
            {'x', p.x < 0 ? -p.x : p.x},
            {'t', 0, p.y < 0 ? "-" : "+"},
            {'y', p.y < 0 ? -p.y : p.y}});
    text += after;
}

[[nodiscard]] inline std::string disc_hardware_text(int points) {
    std::string text = filled(R"GLSL(
// umbrage_disc_hardware$n: $n points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP vec2 rotation) {)GLSL",
                              {{'n', points}});
    text += disc_in_uv;
    text += "    UMBRAGE_HIGHP float n = 0.0;\n";
    for (const disc_point p : umbrage::detail::points_of_disc(points))
        append_point(text, p, "    n += umbrage_lit_at(map, size, ", ", receiver);\n");
    append(text,
           R"GLSL(    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / $n.0) : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL",
           {{'n', points}});
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet disc_hardware{
    .name = Points == 8 ? "disc_hardware8" : (Points == 16 ? "disc_hardware16" : "disc_hardware32"),
    .summary = Points == 8    ? "disc of 8 points by a comparison sampler with a linear filter"
               : Points == 16 ? "disc of 16 points by one"
                              : "disc of 32 points by one",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&in_filter_domain, &within_far_plane, &lit_at>,
    .source = {detail::disc_hardware_text, Points}};

inline constexpr const snippet* disc_hardware_snippets[]{&lit_at, &disc_hardware<8>, &disc_hardware<16>,
                                                         &disc_hardware<32>};

}  // namespace glsl
}  // namespace umbrage
