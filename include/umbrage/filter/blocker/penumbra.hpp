// SPDX-License-Identifier: MIT
//
// How wide a penumbra is, from what lies between a receiver and the light: of suns and of spots, by one formula.
//
//     glm::vec2 units = umbrage::make_light_units(light, map.size());
//     umbrage::penumbra_params soft = umbrage::make_penumbra_params(units, light_radius);
//     glm::vec2 found = umbrage::blockers<16>(fetch, position, receiver, radius, rotation);
//     float mean = umbrage::floor_divide(found.y, found.x);  // of codes, 0 at the light
//     float radius = umbrage::penumbra(umbrage::distance_code(receiver) - mean, glm::vec3(soft));
//
// A spot's z/w is linear in 1 / distance, and so is the width of its penumbras in texels, which grow with the distance:
// radius (1 / d_blocker - 1 / d_receiver) texels a unit at distance 1. Both sides of a division cancel, and no depth is
// made linear. The mean of several blockers' z/w is that of their 1 / distance, whose distance is the harmonic mean:
// penumbras are never smaller than the mean distance would make them.
#pragma once

#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/floor_divide.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// What a light's size makes of distances: whole numbers, or nearly so, that keep all below exact.
struct penumbra_params {
    float per_code = 0.0625f;  ///< penumbra's radius in 1/16 texel, a code between blocker and receiver; 8 bits
    float min_radius = 16.0f;  ///< radius of the filter where blockers touch receivers, 1/16 texel, whole
    float max_radius = 96.0f;  ///< of filter and search, 1/16 texel, whole, at most 4095

    [[nodiscard]] explicit operator glm::vec3() const { return {per_code, min_radius, max_radius}; }
};

/// @param units          make_light_units of the light and the map
/// @param light_size     radius of a spot's lamp in world units; of a directional light the tangent of half the angle
///                       that it is seen under, of the sun 0.00465
/// @param min_radius     the filter's radius where a blocker touches the receiver: 1 hides the map's steps, 0 is hard
/// @param max_radius     wider penumbras are cut to that, and blockers farther off are not found; with 16 points beyond
///                       16 texels or so noise shows
/// @return               per_code rounded to 8 bits, by 1/256 of it at most; 0 for lights of no size: all is min_radius
/// @throws std::invalid_argument  units or size that are not finite or below 0, radii that are not
///                                0 <= min_radius <= max_radius <= 255.9375
/// @formula              per_code = 16 light_size / (65536 units.x units.y)
template <real T>
[[nodiscard]] penumbra_params make_penumbra_params(glm::vec<2, T> units, T light_size, T min_radius = T(1),
                                                   T max_radius = T(16)) {
    constexpr auto function = "make_penumbra_params";
    detail::require(is_finite(light_size) && light_size >= T(0), function, "light_size", "finite, 0 or more",
                    light_size);
    detail::require(detail::all_finite(units) && units.x > T(0) && units.y > T(0), function, "units",
                    "finite and above 0", units);
    detail::require(min_radius >= T(0) && min_radius <= max_radius && max_radius <= T(max_disc_radius), function,
                    "min_radius and max_radius", "in order, from 0 to 255.9375",
                    glm::vec<2, T>(min_radius, max_radius));
    const auto exact = double(light_size) / (4096.0 * double(units.x) * double(units.y));
    int exponent = 0;
    const double digits = std::round(std::frexp(exact < 4096.0 ? exact : 4096.0, &exponent) * 256.0);
    const bool counts = exponent > -24;  // else no penumbra has a 256th of a texel
    return {counts ? static_cast<float>(std::ldexp(digits, exponent - 8)) : 0.0f,
            static_cast<float>(disc_radius(min_radius)), static_cast<float>(disc_radius(max_radius))};
}

/// A depth as its distance from the near plane.
/// @param depth   clamped to [0, 1]; NaN counts as far
/// @return        whole, 0 .. 65535, 0 at the near plane in either direction of depth
/// @formula       x = min(floor(65536 depth), 65535); 65535 - x where depth is reversed
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T distance_code(T depth, Compare is_lit = {}) {
    const bool forward = is_lit(T(0), T(1));
    const T v = saturate(depth, forward ? T(1) : T(0)) * T(65536);
    const T code = v < T(65535) ? T(static_cast<int>(v)) : T(65535);
    return forward ? code : T(65535) - code;
}

/// Radius of a penumbra.
/// @param apart      codes from the blocker to the receiver; whole, below 2^16, below 0 as 0
/// @param softness   of make_penumbra_params: (per_code, min_radius, max_radius)
/// @return           in 1/16 texel, whole, from min_radius to max_radius
/// @formula          min(max(floor(apart per_code), min_radius), max_radius)
/// @exactness        A: a product of 24 bits
template <real T>
[[nodiscard]] T penumbra(T apart, glm::vec<3, T> softness) {
    const T radius = std::floor(apart * softness.x);
    return detail::lesser(detail::greater(radius, softness.y), softness.z);
}

/// A texel's part in the search for blockers.
/// @return       (1, its distance_code) where it is before the receiver, else (0, 0)
/// @exactness    A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blocker(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    const auto stored = T(fetch(texel));
    return is_lit(receiver, stored) ? glm::vec<2, T>(T(0), T(0)) : glm::vec<2, T>(T(1), distance_code(stored, is_lit));
}

/// The texels under a disc's points that lie before a receiver.
/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called Points times, texels may lie a radius outside the map
/// @param position   floor(256 coord) of the receiver
/// @param receiver   depth, biased as for the filter; NaN has all texels before it
/// @param radius     in 1/16 texel, whole, 0 .. 4095
/// @param rotation   as disc_rotation gives it
/// @return           (how many, the sum of their distance_codes): whole, a NaN among texels counts as a blocker at the
///                   far plane
/// @exactness        A: a sum below 2^21
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blockers(Fetch&& fetch, glm::vec<2, T> position, T receiver, T radius,
                                      glm::vec<2, T> rotation, Compare is_lit = {}) {
    glm::vec<2, T> found(T(0), T(0));
    for (const glm::ivec2 point : disc_points<Points>)
        found +=
            blocker(fetch, glm::ivec2(disc_tap(position, glm::vec<2, T>(point), rotation, radius)), receiver, is_lit);
    return found;
}

namespace glsl {

inline constexpr snippet distance_code{
    .name = "distance_code",
    .summary = "a depth as 16 bits of distance from the near plane",
    .exactness = tier::a,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
UMBRAGE_HIGHP float umbrage_distance_code(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = depth * 65536.0;
    UMBRAGE_HIGHP float forward = v < 65535.0 ? floor(max(v, 0.0)) : 65535.0;
    UMBRAGE_HIGHP float reversed = v > 0.0 ? floor(min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
)GLSL",
};

inline constexpr snippet penumbra{
    .name = "penumbra",
    .summary = "radius of a penumbra from the distance between blocker and receiver",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
UMBRAGE_HIGHP float umbrage_penumbra(UMBRAGE_HIGHP float apart, UMBRAGE_HIGHP vec3 softness) {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
)GLSL",
};

inline constexpr snippet blocker{
    .name = "blocker",
    .summary = "whether a texel lies before a receiver, and how far from the light",
    .exactness = tier::a,
    .needs = list<&fetch_depth, &compare, &distance_code>,
    .source = R"GLSL(
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel before the receiver, of any other (0.0, 0.0)
UMBRAGE_HIGHP vec2 umbrage_blocker(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_fetch_depth(map, size, texel);
    UMBRAGE_HIGHP float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, code);
}
)GLSL",
};

namespace detail {

/// The search's text, its points a line each.
[[nodiscard]] inline std::string blockers_text(int points) {
    std::string text = filled(R"GLSL(
// umbrage_blockers$n: how many of a disc's $n points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 position,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                      UMBRAGE_HIGHP vec2 rotation) {
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
)GLSL",
                              {{'n', points}});
    for (const disc_point p : umbrage::detail::points_of_disc(points))
        append(text,
               "    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2($x.0, $y.0), rotation, radius), "
               "receiver);\n",
               {{'x', p.x}, {'y', p.y}});
    text += "    return n;\n}\n";
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet blockers{.name = Points == 8 ? "blockers8" : (Points == 16 ? "blockers16" : "blockers32"),
                                  .summary = "texels under a disc's points that lie before a receiver",
                                  .exactness = tier::a,
                                  .needs = list<&disc_tap, &blocker>,
                                  .source = {detail::blockers_text, Points}};

inline constexpr const snippet* penumbra_snippets[]{&distance_code, &penumbra,     &blocker,
                                                    &blockers<8>,   &blockers<16>, &blockers<32>};

}  // namespace glsl
}  // namespace umbrage
