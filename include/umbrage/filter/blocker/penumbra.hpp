// SPDX-License-Identifier: MIT
//
// Blocker search and penumbra width of soft shadows (PCSS, DPCF), by one formula for directional and spot lights.
//
//     glm::vec2 units = umbrage::make_light_units(light, map.size());
//     umbrage::penumbra_params soft = umbrage::make_penumbra_params(units, light_radius);
//     glm::vec2 found = umbrage::blockers<16>(fetch, position, receiver, radius, rotation);
//     float mean = umbrage::floor_divide(found.y, found.x);  // of distance codes, 0 at the light
//     float radius = umbrage::penumbra(umbrage::distance_code(receiver) - mean, glm::vec3(soft));
//
// A spot light's z/w is linear in 1 / distance, and so is the width of its penumbras in texels. It is
// radius (1 / d_blocker - 1 / d_receiver), in texels per unit at distance 1. So no depth has to be made linear.
// The mean z/w of several blockers gives their harmonic mean distance. Penumbras are therefore never smaller than for
// the mean distance.
// Also called: blocker search (blockers); penumbra estimate (penumbra); light size, source radius
// (make_penumbra_params).
// See also: pcss.hpp, dpcf.hpp.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/floor_divide.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/numbers.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Parameters of a penumbra, from the size of the light: integers, or nearly so, which keep the arithmetic exact.
/// make_penumbra_params makes them for one map, or for a shadow, which computes per_code for each of its maps.
struct penumbra_params {
    float per_code = 0.0625f;  ///< penumbra radius in 1/16 texel, per code between blocker and receiver; 8 bits
    float min_radius = 16.0f;  ///< filter radius where blockers touch receivers, 1/16 texel, an integer
    float max_radius = 96.0f;  ///< largest radius of filter and search, 1/16 texel, an integer up to 4095
    float light_size = 0.0f;   ///< for a shadow: size of the light in the world. 0 for a filter by itself

    [[nodiscard]] explicit operator glm::vec3() const { return {per_code, min_radius, max_radius}; }
};

template <>
inline constexpr std::string_view glsl::number_type<penumbra_params> = "vec3";
template <>
inline constexpr int detail::width_of_number<penumbra_params> = 3;

namespace detail {

/// Refuses what make_penumbra_params never makes. With other radii, an image's receivers and one alone would differ.
inline void require_softness(std::string_view function, const penumbra_params& softness) {
    require(is_finite(softness.per_code) && softness.per_code >= 0.0f && softness.per_code <= 4096.0f, function,
            "filter.softness.per_code", "from 0 to 4096", softness.per_code);
    const float low = softness.min_radius, high = softness.max_radius;
    const bool in_order = is_finite(low) && is_finite(high) && low >= 0.0f && low <= high && high <= 4095.0f;
    require(in_order && low == std::floor(low) && high == std::floor(high), function,
            "filter.softness.min_radius and max_radius", "integers in order, from 0 to 4095", glm::vec2(low, high),
            "They are in 1/16 texel: make_penumbra_params computes them.");
    require(softness.light_size == 0.0f, function, "filter.softness.light_size", "0 for a filter by itself",
            softness.light_size, "make_penumbra_params takes the units of its map.");
}

/// Penumbra radius in 1/16 texel per code, for a light of a size in a map of these units; 8 bits.
[[nodiscard]] inline float softness_per_code(const glm::dvec2& units, double light_size) {
    const double exact = light_size / (4096.0 * units.x * units.y);
    int exponent = 0;
    const double digits = std::round(std::frexp(exact < 4096.0 ? exact : 4096.0, &exponent) * 256.0);
    const bool counts = exponent > -24;  // else no penumbra reaches 1/256 texel
    return counts ? static_cast<float>(std::ldexp(digits, exponent - 8)) : 0.0f;
}

}  // namespace detail

/// Parameters of penumbras for a shadow, which computes per_code for each of its maps.
/// @param light_size     spot or point light: its radius in world units. Directional light: tangent of half the angle
///                       under which it is seen; 0.00465 for the sun
/// @param min_radius     filter radius where a blocker touches the receiver, texels. 1 leaves faint stair steps, 1.5
///                       those of tent<3>, 0 is a hard edge
/// @param max_radius     largest filter radius, texels: cuts wider penumbras, and ends the search for blockers. With 16
///                       points, noise shows beyond about 16 texels
/// @throws std::invalid_argument  light_size not finite or not above 0; radii that are not
///                                0 <= min_radius <= max_radius <= 255.9375
template <real T>
[[nodiscard]] penumbra_params make_penumbra_params(T light_size, T min_radius = T(1), T max_radius = T(16)) {
    constexpr auto function = "make_penumbra_params";
    detail::require(is_finite(light_size) && light_size > T(0), function, "light_size", "finite and above 0",
                    light_size);
    detail::require(min_radius >= T(0) && min_radius <= max_radius && max_radius <= T(max_disc_radius), function,
                    "min_radius and max_radius", "in order, from 0 to 255.9375",
                    glm::vec<2, T>(min_radius, max_radius));
    return {0.0f, static_cast<float>(disc_radius(min_radius)), static_cast<float>(disc_radius(max_radius)),
            static_cast<float>(light_size)};
}

/// Parameters of the penumbras of a light in one map, for a filter by itself.
/// @param units        make_light_units of the light and the map
/// @param light_size   as for a shadow, but it may be 0
/// @param min_radius   as for a shadow
/// @param max_radius   as for a shadow
/// @return             parameters; per_code is rounded to 8 bits, by at most 1/256 of itself
/// @edge               light of no size: per_code is 0, and every radius is min_radius
/// @throws std::invalid_argument  units or light_size not finite or below 0; radii that are not
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
    penumbra_params made = make_penumbra_params(T(1), min_radius, max_radius);
    made.per_code = detail::softness_per_code(glm::dvec2(units), double(light_size));
    made.light_size = 0.0f;
    return made;
}

/// Distance of a depth from the near plane, as a code of 16 bits.
/// @param depth   in [0, 1]; clamped
/// @param is_lit  less_equal, or greater_equal for reversed depth
/// @return        integer, 0 .. 65535; 0 at the near plane, also where depth is reversed
/// @edge          NaN: 65535, as the far plane
/// @formula       x = min(floor(65536 depth), 65535); 65535 - x where depth is reversed
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T distance_code(T depth, Compare is_lit = {}) {
    const bool forward = is_lit(T(0), T(1));
    const T v = saturate(depth, forward ? T(1) : T(0)) * T(65536);
    const T code = v < T(65535) ? T(static_cast<int>(v)) : T(65535);
    return forward ? code : T(65535) - code;
}

/// Radius of a penumbra from the distance between blocker and receiver.
/// @param apart      distance code of the receiver minus that of the blocker, an integer below 2^16; negative is 0
/// @param softness   (per_code, min_radius, max_radius), from make_penumbra_params
/// @return           in 1/16 texel, an integer from min_radius to max_radius. Other values of softness give other
///                   results
/// @formula          min(max(floor(apart per_code), min_radius), max_radius)
/// @exactness        A: a product of 24 bits
template <real T>
[[nodiscard]] T penumbra(T apart, glm::vec<3, T> softness) {
    const T radius = std::floor(apart * softness.x);
    return (glm::min)((glm::max)(radius, softness.y), softness.z);
}

/// Count and distance code of one texel, if it is nearer to the light than the receiver.
/// @return       (1, its distance_code) for a blocker, else (0, 0)
/// @exactness    A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blocker(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    const auto stored = T(fetch(texel));
    return is_lit(receiver, stored) ? glm::vec<2, T>(T(0), T(0)) : glm::vec<2, T>(T(1), distance_code(stored, is_lit));
}

/// Count and distance sum of a disc's points that fall on blockers: texels nearer to the light than the receiver.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called Points times, with indices up to a
///                   radius outside the map
/// @param position   floor(256 coord) of the receiver, in 1/256 texel
/// @param receiver   receiver depth in [0, 1], with the same bias as for the filter
/// @param radius     in 1/16 texel, an integer, 0 .. 4095
/// @param rotation   from disc_rotation
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           (number of blockers, sum of their distance_codes): integers
/// @edge             NaN receiver: every texel blocks. NaN texel: a blocker at the far plane. Radius beyond 4095 to
///                   either side: clamped; NaN: 0. rotation NaN or longer than any of disc_rotation: (64, 0)
/// @exactness        A: a sum below 2^21
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blockers(Fetch&& fetch, glm::vec<2, T> position, T receiver, T radius,
                                      glm::vec<2, T> rotation, Compare is_lit = {}) {
    const T rho = is_nan(radius) ? T(0) : (glm::clamp)(radius, T(-4095), T(4095));
    const glm::vec<2, T> turn = detail::bounded_rotation(rotation);
    glm::vec<2, T> found(T(0), T(0));
    for (const glm::ivec2 point : disc_points<Points>)
        found += blocker(fetch, glm::ivec2(disc_tap(position, glm::vec<2, T>(point), turn, rho)), receiver, is_lit);
    return found;
}

namespace glsl {

inline constexpr snippet distance_code{
    .name = "distance_code",
    .summary = "distance of a depth from the near plane, 16 bits",
    .exactness = tier::a,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
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
    .summary = "radius of a penumbra from the distance to the blocker",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_penumbra: radius of a penumbra in 1/16 texel, an integer
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code, min_radius, max_radius), from make_penumbra_params
UMBRAGE_HIGHP float umbrage_penumbra(UMBRAGE_HIGHP float apart, UMBRAGE_HIGHP vec3 softness) {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
)GLSL",
};

inline constexpr snippet blocker{
    .name = "blocker",
    .summary = "count and distance code of one possible blocker",
    .exactness = tier::a,
    .needs = list<&fetch_depth, &compare, &distance_code>,
    .source = R"GLSL(
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
UMBRAGE_HIGHP vec2 umbrage_blocker(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_fetch_depth(map, size, texel);
    UMBRAGE_HIGHP float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, code);
}
)GLSL",
};

namespace detail {

/// Shader text of the search, one line per point.
[[nodiscard]] inline std::string blockers_text(int points) {
    std::string text = filled(R"GLSL(
// umbrage_blockers$n: (number of blockers, sum of their distance codes) at $n points of a disc
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in 1/16 texel, an integer from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
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
                                  .summary = "blocker search over a disc's points",
                                  .exactness = tier::a,
                                  .needs = list<&disc_tap, &blocker>,
                                  .source = {detail::blockers_text, Points}};

inline constexpr const snippet* penumbra_snippets[]{&distance_code, &penumbra,     &blocker,
                                                    &blockers<8>,   &blockers<16>, &blockers<32>};

}  // namespace glsl
}  // namespace umbrage
