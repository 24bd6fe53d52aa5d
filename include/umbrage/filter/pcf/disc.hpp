// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) over a disc of 8, 16 or 32 points, rotated per pixel to hide the pattern.
//
//     float visibility =
//         umbrage::disc<16>(umbrage::bordered(map), coord, depth - bias, 3.0f, umbrage::disc_rotation(pixel));
//
// An ellipse of these points is a disc in the world where texels are not square (ellipse).
// Also called: Poisson disk, Vogel disk, rotated disc PCF (disc, disc_rotation).
// See also: disc_tap.hpp, disc_hardware.hpp, blocker/pcss.hpp.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include <umbrage/core/check.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/disc_tap.hpp>

namespace umbrage {

/// Fraction of the points of an ellipse that are lit. Where texels are not square, a disc in the world is such an
/// ellipse.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called Points times, with indices up to a
///                   radius outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param radius     along x and y, in 1/16 texel, integers from 0 to 4095: disc_radius or penumbra gives them
/// @param rotation   from disc_rotation. Trades banding for noise
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit. A multiple of 1 / Points
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0. Radius
///                   beyond 4095 to either side: clamped; NaN: 0. rotation NaN or of components above 576: (64, 0,
///                   0, 64)
/// @formula          mean of [receiver <= fetch(disc_tap)] over disc_points
/// @exactness        A
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T ellipse(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> radius, glm::vec<4, T> rotation,
                        Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> position = glm::floor(coord * T(256)), rho = detail::bounded_radius(radius);
    const glm::vec<4, T> turn = detail::bounded_rotation(rotation);
    int lit = 0;
    for (const glm::ivec2 point : disc_points<Points>) {
        const glm::ivec2 texel(disc_tap(position, glm::vec<2, T>(point), turn, rho));
        lit += is_lit(receiver, T(fetch(texel))) ? 1 : 0;
    }
    return static_cast<T>(lit) * T(1.0 / Points);
}

/// Fraction of a disc's points that are lit.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called Points times, with indices up to a
///                   radius outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param radius     in texels, rounded down to 1/16; clamped to 0 .. 255.9375, NaN is 0
/// @param rotation   from disc_rotation. Trades banding for noise
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit. A multiple of 1 / Points
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0. rotation
///                   NaN or of components above 576: (64, 0, 0, 64)
/// @formula          mean of [receiver <= fetch(disc_tap)] over disc_points
/// @exactness        A
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T disc(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T radius, glm::vec<4, T> rotation,
                     Compare is_lit = {}) {
    return ellipse<Points>(fetch, coord, receiver, glm::vec<2, T>(disc_radius(radius)), rotation, is_lit);
}

namespace glsl {

namespace detail {

/// Shader text of an ellipse, one line per point.
[[nodiscard]] inline std::string ellipse_text(int points) {
    std::string text = filled(R"GLSL(
// umbrage_ellipse$n: PCF over a rotated ellipse of $n points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_ellipse$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 radius,
                                      UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float n = 0.0;
)GLSL",
                              {{'n', points}});
    for (const disc_point p : umbrage::detail::points_of_disc(points))
        append(text,
               "    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2($x.0, $y.0), rotation, radius), receiver);\n",
               {{'x', p.x}, {'y', p.y}});
    append(text, "    return compared ? n * (1.0 / $n.0) : 1.0;\n}\n", {{'n', points}});
    return text;
}

[[nodiscard]] inline std::string disc_text(int points) {
    return filled(R"GLSL(
// umbrage_disc$n: PCF over a rotated disc of $n points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                   UMBRAGE_HIGHP vec4 rotation) {
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse$n(map, size, coord, receiver, vec2(rho, rho), rotation);
}
)GLSL",
                  {{'n', points}});
}

}  // namespace detail

template <int Points>
inline constexpr snippet ellipse{.name = Points == 8 ? "ellipse8" : (Points == 16 ? "ellipse16" : "ellipse32"),
                                 .summary = Points == 8    ? "PCF over an ellipse, 8 points, rotated per pixel"
                                            : Points == 16 ? "PCF over an ellipse, 16 points, rotated per pixel"
                                                           : "PCF over an ellipse, 32 points, rotated per pixel",
                                 .exactness = tier::a,
                                 .needs = list<&in_filter_domain, &disc_tap, &lit>,
                                 .source = {detail::ellipse_text, Points}};

template <int Points>
inline constexpr snippet disc{.name = Points == 8 ? "disc8" : (Points == 16 ? "disc16" : "disc32"),
                              .summary = Points == 8    ? "disc PCF, 8 points, rotated per pixel"
                                         : Points == 16 ? "disc PCF, 16 points, rotated per pixel"
                                                        : "disc PCF, 32 points, rotated per pixel",
                              .exactness = tier::a,
                              .needs = list<&disc_radius, &ellipse<Points>>,
                              .source = {detail::disc_text, Points}};

inline constexpr const snippet* disc_snippets[]{&ellipse<8>, &ellipse<16>, &ellipse<32>,
                                                &disc<8>,    &disc<16>,    &disc<32>};

}  // namespace glsl

namespace filters {

/// Disc filter as a value. Functions over images rotate it per pixel.
struct disc {
    int points = 16;  ///< 8, 16 or 32. check refuses others; alone they count as 32
    float radius_texels = 2.0f;
    depth_direction direction = depth_direction::forward;
    const glsl::snippet* snippet = points == 8 ? &glsl::disc<8> : points == 16 ? &glsl::disc<16> : &glsl::disc<32>;
    std::string_view name = snippet->name;

    static const std::array<disc, 3> values;
    static constexpr auto numbers(auto& f) { return std::tie(f.radius_texels); }

    /// @throws std::invalid_argument  points other than 8, 16 and 32, in the name of `function`
    void check(std::string_view function) const {
        detail::require(points == 8 || points == 16 || points == 32, function, "filter.points", "8, 16 or 32", points);
    }
    /// Distance from a receiver to the farthest point, in texels.
    [[nodiscard]] constexpr float farthest_point() const {
        const float sixteenths = points == 8 ? 13.0385f : (points == 16 ? 14.1422f : 15.0f);
        return disc_radius(radius_texels) * sixteenths * (1.0f / 256.0f);
    }
    [[nodiscard]] constexpr float reach() const {
        const float along_axis = points == 8 ? 13.0f : (points == 16 ? 14.0f : 15.0f);  // 1/16, in any rotation
        return disc_radius(radius_texels) * along_axis * (1.0f / 256.0f) + (0.5f + 1.0f / 128.0f);
    }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        const glm::vec4 rotation = disc_rotation(glm::vec2(pixel));
        if (points == 8)
            return umbrage::disc<8>(fetch, coord, receiver, radius_texels, rotation, comparison{direction});
        if (points == 16)
            return umbrage::disc<16>(fetch, coord, receiver, radius_texels, rotation, comparison{direction});
        return umbrage::disc<32>(fetch, coord, receiver, radius_texels, rotation, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

inline constexpr std::array<disc, 3> disc::values{{{.points = 8}, {.points = 16}, {.points = 32}}};

}  // namespace filters
}  // namespace umbrage
