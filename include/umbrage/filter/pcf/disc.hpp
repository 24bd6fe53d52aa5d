// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) over a disc of 8, 16 or 32 points, rotated per pixel to hide the pattern.
//
//     float visibility =
//         umbrage::disc<16>(umbrage::bordered(map), coord, depth - bias, 3.0f, umbrage::disc_rotation(pixel));
//
// Points, rotations and radii are integers, so the taps fall on the same texels everywhere. The points were annealed
// for the smallest error on edges of any direction, alone and over four rotations by 90 degrees.
// Also called: Poisson disk, Vogel disk, rotated disc PCF (disc, disc_rotation).
// See also: disc_hardware.hpp, blocker/pcss.hpp.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include <umbrage/core/check.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>

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

/// Rotation from disc_rotation, whose components are at most 64. Any other, NaN included: the first one.
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> bounded_rotation(glm::vec<2, T> rotation) {
    return inside_texel_space(rotation * T(511)) ? rotation : glm::vec<2, T>(T(64), T(0));
}

}  // namespace detail

/// Rotation of the disc for a pixel: one of 16, each used once in every 4 x 4 pixels.
/// @param pixel      pixel position, in pixels; fractions are dropped
/// @return           (cos, sin) in 1/64: integers, length 63.6 to 64
/// @edge             |x| or |y| >= 2^15, or NaN: the first rotation, (64, 0)
/// @formula          v = 4x + y mod 16; rotates by floor(v / 4) quarter turns and (v mod 4) times 22.5 degrees
/// @exactness        A
template <real T>
[[nodiscard]] glm::vec<2, T> disc_rotation(glm::vec<2, T> pixel) {
    if (!inside_texel_space(pixel)) return {T(64), T(0)};
    const glm::vec<2, T> whole = glm::floor(pixel);
    const T sum = whole.x * T(4) + whole.y;
    const auto v = static_cast<int>(sum - glm::floor(sum * T(1.0 / 16.0)) * T(16));
    constexpr int base[4][2]{{64, 0}, {59, 24}, {45, 45}, {24, 59}};
    const T c = T(base[v % 4][0]), s = T(base[v % 4][1]);
    switch (v / 4) {
        case 0: return {c, s};
        case 1: return {T(0) - s, c};
        case 2: return {T(0) - c, T(0) - s};
        default: return {s, T(0) - c};
    }
}

/// Texel that a point of a disc falls on.
/// @param position   floor(256 coord) of the receiver, in 1/256 texel
/// @param p          one of disc_points, in 1/16 of the radius
/// @param rotation   from disc_rotation
/// @param radius     in 1/16 texel, an integer from 0 to 4095
/// @return           index of the texel
/// @formula          floor((position + rotated point * radius / 64) / 256), where (c, s) rotates point (x, y) to
///                   (c x - s y, s x + c y)
/// @exactness        A: multiples of 2^-14 below 2^10, in any order
template <real T>
[[nodiscard]] glm::vec<2, T> disc_tap(glm::vec<2, T> position, glm::vec<2, T> p, glm::vec<2, T> rotation, T radius) {
    const glm::vec<2, T> at = position * T(1.0 / 256.0), texel = glm::floor(at);
    const glm::vec<2, T> within = glm::clamp(at - texel, T(0), T(1));  // no sum is regrouped across the clamp
    const glm::vec<2, T> scaled = rotation * (radius * T(1.0 / 16384.0));
    return texel +
           glm::floor(within + glm::vec<2, T>(scaled.x * p.x - scaled.y * p.y, scaled.y * p.x + scaled.x * p.y));
}

/// Radius of a disc in 1/16 texel, from one in texels: floor(16 radius), at most 4095. Negative or NaN: 0.
/// @exactness        A
template <real T>
[[nodiscard]] constexpr T disc_radius(T radius) {
    if (is_nan(radius) || !(radius > T(0))) return T(0);
    return radius < T(255.9375) ? T(static_cast<int>(radius * T(16))) : T(4095);
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
///                   NaN or longer than any of disc_rotation: (64, 0)
/// @formula          mean of [receiver <= fetch(disc_tap)] over disc_points
/// @exactness        A
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T disc(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T radius, glm::vec<2, T> rotation,
                     Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> position = glm::floor(coord * T(256)), turn = detail::bounded_rotation(rotation);
    const T rho = disc_radius(radius);
    int lit = 0;
    for (const glm::ivec2 point : disc_points<Points>) {
        const glm::ivec2 texel(disc_tap(position, glm::vec<2, T>(point), turn, rho));
        lit += is_lit(receiver, T(fetch(texel))) ? 1 : 0;
    }
    return static_cast<T>(lit) * T(1.0 / Points);
}

namespace glsl {

inline constexpr snippet disc_rotation{
    .name = "disc_rotation",
    .summary = "rotation of a disc for a pixel, one of 16",
    .exactness = tier::a,
    .needs = list<&inside_texel_space>,
    .source = R"GLSL(
// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, sin) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
UMBRAGE_HIGHP vec2 umbrage_disc_rotation(UMBRAGE_HIGHP vec2 pixel) {
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
    return quarter < 1.5 ? once : twice;
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
//   radius     in 1/16 texel, an integer from 0 to 4095
UMBRAGE_HIGHP vec2 umbrage_disc_tap(UMBRAGE_HIGHP vec2 position, UMBRAGE_HIGHP vec2 p, UMBRAGE_HIGHP vec2 rotation,
                                    UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP vec2 at = position * (1.0 / 256.0);
    UMBRAGE_HIGHP vec2 texel = floor(at);
    UMBRAGE_HIGHP vec2 within = clamp(at - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));  // no sum is regrouped across it
    UMBRAGE_HIGHP vec2 scaled = rotation * (radius * (1.0 / 16384.0));
    UMBRAGE_HIGHP float x = scaled.x * p.x + within.x - scaled.y * p.y;
    UMBRAGE_HIGHP float y = scaled.y * p.x + within.y + scaled.x * p.y;
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

namespace detail {

/// Shader text of a disc, one line per point.
[[nodiscard]] inline std::string disc_text(int points) {
    std::string text = filled(R"GLSL(
// umbrage_disc$n: PCF over a rotated disc of $n points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    UMBRAGE_HIGHP float n = 0.0;
)GLSL",
                              {{'n', points}});
    for (const disc_point p : umbrage::detail::points_of_disc(points))
        append(text,
               "    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2($x.0, $y.0), rotation, rho), receiver);\n",
               {{'x', p.x}, {'y', p.y}});
    append(text, "    return compared ? n * (1.0 / $n.0) : 1.0;\n}\n", {{'n', points}});
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet disc{.name = Points == 8 ? "disc8" : (Points == 16 ? "disc16" : "disc32"),
                              .summary = Points == 8    ? "disc PCF, 8 points, rotated per pixel"
                                         : Points == 16 ? "disc PCF, 16 points, rotated per pixel"
                                                        : "disc PCF, 32 points, rotated per pixel",
                              .exactness = tier::a,
                              .needs = list<&in_filter_domain, &disc_radius, &disc_tap, &lit>,
                              .source = {detail::disc_text, Points}};

inline constexpr const snippet* disc_snippets[]{&disc_rotation, &disc_tap, &disc_radius,
                                                &disc<8>,       &disc<16>, &disc<32>};

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
        const glm::vec2 rotation = disc_rotation(glm::vec2(pixel));
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
