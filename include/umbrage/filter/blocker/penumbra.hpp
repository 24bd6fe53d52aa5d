// SPDX-License-Identifier: MIT
//
// Blocker search and penumbra width of soft shadows (PCSS, DPCF), by one formula for directional and spot lights.
//
//     umbrage::penumbra_params soft = umbrage::make_penumbra_params(light, map.size(), light_radius);
//     glm::vec2 found = umbrage::blockers<16>(fetch, position, receiver, search, rotation);
//     float mean = umbrage::floor_divide(found.y, found.x);  // of distance codes, 0 at the light
//     glm::vec2 radius = umbrage::penumbra(umbrage::distance_code(receiver) - mean, glm::vec4(soft));
//
// A spot light's z/w is linear in 1 / distance, and so is the width of its penumbras in texels. It is
// radius (1 / d_blocker - 1 / d_receiver), in texels per unit at distance 1. So no depth has to be made linear.
// A penumbra has a radius along x and one along y, in texels. They differ where texels are not square.
// The mean z/w of several blockers gives their harmonic mean distance. Penumbras are therefore never smaller than for
// the mean distance.
// Also called: blocker search (blockers); penumbra estimate (penumbra); light size, source radius
// (make_penumbra_params).
// See also: pcss.hpp, dpcf.hpp.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/floor_divide.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/numbers.hpp>
#include <umbrage/filter/pcf/disc_tap.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texel_units.hpp>

namespace umbrage {

/// Parameters of a penumbra, from the size of the light: integers, or nearly so, which keep the arithmetic exact.
/// make_penumbra_params makes them for one map, or for a shadow, which computes the first two for each of its maps.
struct penumbra_params {
    float per_code_x =
        0.0625f;  ///< penumbra radius along x in 1/16 texel, per code between blocker and receiver; 8 bits
    float per_code_y = 0.0625f;  ///< the same along y. The two are equal where texels are square
    float min_radius = 16.0f;    ///< filter radius where blockers touch receivers, 1/16 texel, an integer
    float max_radius = 96.0f;    ///< largest radius of filter and search, 1/16 texel, an integer up to 4095
    float light_size = 0.0f;     ///< for a shadow: size of the light in the world. 0 for a filter by itself

    [[nodiscard]] explicit operator glm::vec4() const { return {per_code_x, per_code_y, min_radius, max_radius}; }
};

template <>
inline constexpr std::string_view glsl::number_type<penumbra_params> = "vec4";
template <>
inline constexpr int detail::width_of_number<penumbra_params> = 4;

namespace detail {

/// Refuses what make_penumbra_params never makes. With other radii, an image's receivers and one alone would differ.
inline void require_softness(std::string_view function, const penumbra_params& softness) {
    const float x = softness.per_code_x, y = softness.per_code_y;
    require(x >= 0.0f && x <= 4096.0f && y >= 0.0f && y <= 4096.0f, function,
            "filter.softness.per_code_x and per_code_y", "from 0 to 4096", glm::vec2(x, y));
    const float low = softness.min_radius, high = softness.max_radius;
    const bool in_order = is_finite(low) && is_finite(high) && low >= 0.0f && low <= high && high <= 4095.0f;
    require(in_order && low == std::floor(low) && high == std::floor(high), function,
            "filter.softness.min_radius and max_radius", "integers in order, from 0 to 4095", glm::vec2(low, high),
            "They are in 1/16 texel: make_penumbra_params computes them.");
    require(softness.light_size == 0.0f, function, "filter.softness.light_size", "0 for a filter by itself",
            softness.light_size, "make_penumbra_params takes the light and its map's size.");
}

/// Penumbra radius along an axis in 1/16 texel per code, for a light of a size; 8 bits.
/// @param edge    of a texel along the axis, world units
/// @param depth   per world unit along the light
[[nodiscard]] inline float softness_per_code(double edge, double depth, double light_size) {
    const double exact = light_size / (4096.0 * edge * depth);
    int exponent = 0;
    const double digits = std::round(std::frexp(exact < 4096.0 ? exact : 4096.0, &exponent) * 256.0);
    const bool counts = exponent > -24;  // else no penumbra reaches 1/256 texel
    return counts ? static_cast<float>(std::ldexp(digits, exponent - 8)) : 0.0f;
}

}  // namespace detail

/// Parameters of penumbras for a shadow, which computes per_code_x and per_code_y for each of its maps.
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
    return {.per_code_x = 0.0f,
            .per_code_y = 0.0f,
            .min_radius = static_cast<float>(disc_radius(min_radius)),
            .max_radius = static_cast<float>(disc_radius(max_radius)),
            .light_size = static_cast<float>(light_size)};
}

/// Parameters of the penumbras of a light in one map, for a filter by itself.
/// @param light        light without a warp. A point light: one of make_point_light
/// @param map_size     map size in texels, each >= 1
/// @param light_size   as for a shadow, but it may be 0
/// @param min_radius   as for a shadow
/// @param max_radius   as for a shadow
/// @return             parameters; per_code_x and per_code_y are rounded to 8 bits, by at most 1/256 of themselves
/// @edge               light of no size: they are 0, and every radius is min_radius
/// @throws std::invalid_argument  map_size below 1; a clip space unset; a warped map; light_size not finite or below
///                                0; radii that are not 0 <= min_radius <= max_radius <= 255.9375
/// @formula            per_code = 16 light_size / (65536 edge depth), with the edge of a texel, and depth per world
///                     unit, at w = 1
template <real T>
[[nodiscard]] penumbra_params make_penumbra_params(const light_space<T>& light, glm::ivec2 map_size,
                                                   std::type_identity_t<T> light_size,
                                                   std::type_identity_t<T> min_radius = T(1),
                                                   std::type_identity_t<T> max_radius = T(16)) {
    constexpr auto function = "make_penumbra_params";
    detail::require(is_finite(light_size) && light_size >= T(0), function, "light_size", "finite, 0 or more",
                    light_size);
    const glm::dvec3 units(detail::texel_units(light, map_size, function));
    penumbra_params made = make_penumbra_params(T(1), min_radius, max_radius);
    made.per_code_x = detail::softness_per_code(units.x, units.z, double(light_size));
    made.per_code_y = detail::softness_per_code(units.y, units.z, double(light_size));
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
/// @param softness   (per_code_x, per_code_y, min_radius, max_radius), from make_penumbra_params
/// @return           along x and y, in 1/16 texel, integers from min_radius to max_radius. Other values of softness
///                   give other results
/// @formula          min(max(floor(apart per_code), min_radius), max_radius)
/// @exactness        A: products of 24 bits
template <real T>
[[nodiscard]] glm::vec<2, T> penumbra(T apart, glm::vec<4, T> softness) {
    const glm::vec<2, T> radius = glm::floor(apart * glm::vec<2, T>(softness));
    return (glm::min)((glm::max)(radius, softness.z), softness.w);
}

/// Count and distance code of one texel, if it is nearer to the light than the receiver.
/// @return       (1, its distance_code) for a blocker, else (0, 0)
/// @exactness    A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blocker(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    const auto stored = T(fetch(texel));
    return is_lit(receiver, stored) ? glm::vec<2, T>(T(0), T(0)) : glm::vec<2, T>(T(1), distance_code(stored, is_lit));
}

/// Count and distance sum of an ellipse's points that fall on blockers: texels nearer to the light than the receiver.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called Points times, with indices up to a
///                   radius outside the map
/// @param position   floor(256 coord) of the receiver, in 1/256 texel
/// @param receiver   receiver depth in [0, 1], with the same bias as for the filter
/// @param radius     along x and y, in 1/16 texel, integers from 0 to 4095: penumbra gives them
/// @param rotation   from disc_rotation
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           (number of blockers, sum of their distance_codes): integers
/// @edge             NaN receiver: every texel blocks. NaN texel: a blocker at the far plane. Radius beyond 4095 to
///                   either side: clamped; NaN: 0. rotation NaN or of components above 576: (64, 0, 0, 64)
/// @exactness        A: a sum below 2^21
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blockers(Fetch&& fetch, glm::vec<2, T> position, T receiver, glm::vec<2, T> radius,
                                      glm::vec<4, T> rotation, Compare is_lit = {}) {
    const glm::vec<4, T> turn = detail::bounded_rotation(rotation);
    const glm::vec<2, T> rho = detail::bounded_radius(radius);
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
// umbrage_penumbra: radius of a penumbra along x and y in 1/16 texel, integers
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
UMBRAGE_HIGHP vec2 umbrage_penumbra(UMBRAGE_HIGHP float apart, UMBRAGE_HIGHP vec4 softness) {
    UMBRAGE_HIGHP vec2 radius = floor(vec2(softness.x, softness.y) * apart);
    return min(max(radius, vec2(softness.z, softness.z)), vec2(softness.w, softness.w));
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
// umbrage_blockers$n: (number of blockers, sum of their distance codes) at $n points of an ellipse
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 position,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 radius,
                                      UMBRAGE_HIGHP vec4 rotation) {
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
                                  .summary = "blocker search over an ellipse's points",
                                  .exactness = tier::a,
                                  .needs = list<&disc_tap, &blocker>,
                                  .source = {detail::blockers_text, Points}};

inline constexpr const snippet* penumbra_snippets[]{&distance_code, &penumbra,     &blocker,
                                                    &blockers<8>,   &blockers<16>, &blockers<32>};

}  // namespace glsl
}  // namespace umbrage
