// SPDX-License-Identifier: MIT
//
// Percentage-closer soft shadows (PCSS) in floats, with samplers: half the instructions of pcss.hpp, but not the same
// bits on every GPU.
//
//     float visibility = umbrage::pcss_hardware<16>(umbrage::bordered(map), coord, depth - bias, glm::vec4(soft),
//                                                   umbrage::disc_rotation(pixel));
//
// A shader binds one texture twice. The search reads depths from a nearest-texel sampler: bind it as `texture::depth`
// with gather set, which says that there is one. The filter reads from a linear comparison sampler.
//
//     vec4 rotation = umbrage_disc_rotation(gl_FragCoord.xy);
//     vec2 search = umbrage_pcss_radius(vec2(0.0, 0.0), receiver, soft);
//     vec2 found = umbrage_blockers_hardware16_depths(depths, size, coord, receiver, search, rotation);
//     vec2 radius = umbrage_pcss_radius(found, receiver, soft);
//     float visibility = 1.0;
//     if (found.x > 0.5) visibility = umbrage_ellipse_hardware16_sun(sun, size, coord, receiver, radius, rotation);
//
// A point of the search that lies within a rounding error of a texel's border may read the next texel.
// Also called: PCSS with samplers.
// See also: pcss.hpp, exact on every GPU.
#pragma once

#include <string>

#include <glm/common.hpp>

#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/filter/pcf/disc_hardware.hpp>

namespace umbrage {

/// Count and depth of one point of the map, if it is nearer to the light than the receiver.
/// @return        (1, depth_at) for a blocker, else (0, 0)
/// @exactness     C, n = 4, as depth_at
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blocker_at(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv, T receiver,
                                        Compare is_lit = {}) {
    const T stored = depth_at(fetch, size, uv);
    return is_lit(receiver, stored) ? glm::vec<2, T>(T(0), T(0)) : glm::vec<2, T>(T(1), stored);
}

/// Count and depth sum of an ellipse's points that are nearer to the light than the receiver. Points are not rounded.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called Points times, with indices up to a
///                   radius outside the map
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the same bias as for the filter
/// @param radius     along x and y, in texels; clamped to 0 .. 255.9375, NaN is 0
/// @param rotation   from disc_rotation
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           (number of blockers, sum of their depths)
/// @edge             coord outside texel space or NaN, receiver beyond the far plane, NaN rotation: no blockers. NaN
///                   receiver: every point blocks. Depths that are not finite give a sum that is not finite
/// @formula          sum of (1, stored) over the texels under disc_position with stored < receiver
/// @exactness        C, n = 24: exact in a shader except at borders between texels, as depth_at. S is disc_position's
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blockers_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> radius,
                                               glm::vec<4, T> rotation, Compare is_lit = {}) {
    glm::vec<2, T> found(T(0), T(0));
    if (!in_filter_domain(coord, receiver, is_lit)) return found;
    const glm::vec<2, T> rho = clamped_disc_radius(radius);
    for (const glm::ivec2 point : disc_points<Points>) {
        const glm::vec<2, T> at = disc_position(coord, glm::vec<2, T>(point), rotation, rho);
        const T reached = glm::abs(at.x) + glm::abs(at.y);
        if (is_nan(reached) || reached >= T(1 << 17)) continue;  // not a rotation from disc_rotation
        const auto stored = T(fetch(glm::ivec2(glm::floor(at))));
        if (!is_lit(receiver, stored)) found += glm::vec<2, T>(T(1), stored);
    }
    return found;
}

/// Radius of the penumbra that blockers cast on a receiver.
///
/// Without a blocker, found is (0, 0) and the radius is that of a blocker at the near plane. The search needs no more.
/// @param found      (number of blockers, sum of their depths)
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param softness   (per_code_x, per_code_y, min_radius, max_radius), from make_penumbra_params
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           along x and y, in texels, from min_radius / 16 to max_radius / 16. NaN: min_radius / 16
/// @formula          |receiver - mean| 4096 per_code, clamped
/// @exactness        C, within 1/1024: a mean off by 4 ulp moves it by 2^-9 per_code, up to a per_code of 1/2
/// @cite             Fernando: Percentage-closer soft shadows, SIGGRAPH 2005 sketches
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr glm::vec<2, T> pcss_radius(glm::vec<2, T> found, T receiver, glm::vec<4, T> softness,
                                                   Compare is_lit = {}) {
    const bool forward = is_lit(T(0), T(1));
    const T mean = found.x > T(0.5) ? found.y / found.x : (forward ? T(0) : T(1));
    const T apart = forward ? receiver - mean : mean - receiver;
    const T min_radius = softness.z * T(0.0625), max_radius = softness.w * T(0.0625);
    const auto radius = [&](T per_code) {
        const T exact = apart * (per_code * T(4096));
        return exact > min_radius ? (glm::min)(exact, max_radius) : min_radius;
    };
    return {radius(softness.x), radius(softness.y)};
}

/// Visibility of a receiver under a light that has a size, in floats.
/// @tparam Points    8, 16 or 32: points of the search, and again of the filter
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called up to 5 Points times
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param softness   (per_code_x, per_code_y, min_radius, max_radius), from make_penumbra_params
/// @param rotation   from disc_rotation. Trades banding for noise
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit
/// @edge             no blocker found: 1. coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN
///                   receiver: 0
/// @formula          ellipse_hardware(pcss_radius(blockers_hardware(pcss_radius(none))))
/// @exactness        C, for the same blockers: 1/128 plus the error of the radius
/// @cite             Fernando: Percentage-closer soft shadows, SIGGRAPH 2005 sketches
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcss_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<4, T> softness,
                              glm::vec<4, T> rotation, Compare is_lit = {}) {
    const auto search = pcss_radius(glm::vec<2, T>(T(0), T(0)), receiver, softness, is_lit);
    const auto found = blockers_hardware<Points>(fetch, coord, receiver, search, rotation, is_lit);
    if (!(found.x > T(0))) return T(1);
    const auto radius = pcss_radius(found, receiver, softness, is_lit);
    return ellipse_hardware<Points>(fetch, coord, receiver, radius, rotation, is_lit);
}

namespace glsl {

inline constexpr snippet blocker_at{
    .name = "blocker_at",
    .summary = "count and depth of one possible blocker",
    .exactness = tier::c,
    .operations = 4,
    .needs = list<&depth_at, &compare>,
    .source = R"GLSL(
// umbrage_blocker_at: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP vec2 umbrage_blocker_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, stored);
}
)GLSL",
};

inline constexpr snippet pcss_radius{
    .name = "pcss_radius",
    .summary = "penumbra radius from the mean depth of blockers",
    .exactness = tier::c,
    .within = 1.0f / 1024.0f,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_pcss_radius: radius of a penumbra along x and y in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
UMBRAGE_HIGHP vec2 umbrage_pcss_radius(UMBRAGE_HIGHP vec2 found, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP vec4 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    UMBRAGE_HIGHP float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    UMBRAGE_HIGHP float apart = forward ? receiver - mean : mean - receiver;
    UMBRAGE_HIGHP vec2 radius = vec2(softness.x, softness.y) * 4096.0 * apart;
    UMBRAGE_HIGHP float min_radius = softness.z * 0.0625;
    UMBRAGE_HIGHP float max_radius = softness.w * 0.0625;
    return vec2(radius.x > min_radius ? min(radius.x, max_radius) : min_radius,
                radius.y > min_radius ? min(radius.y, max_radius) : min_radius);
}
)GLSL",
};

namespace detail {

[[nodiscard]] inline std::string blockers_hardware_text(int points) {
    std::string text = filled(R"GLSL(
// umbrage_blockers_hardware$n: (number of blockers, sum of their depths) at $n points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                               UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 radius,
                                               UMBRAGE_HIGHP vec4 rotation) {)GLSL",
                              {{'n', points}});
    text += disc_in_uv;
    text += "    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);\n";
    for (const disc_point p : umbrage::detail::points_of_disc(points))
        append_point(text, p, "    n += umbrage_blocker_at(map, size, ", ", receiver);\n");
    text += "    return compared ? n : vec2(0.0, 0.0);\n}\n";
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet blockers_hardware{
    .name = Points == 8 ? "blockers_hardware8" : (Points == 16 ? "blockers_hardware16" : "blockers_hardware32"),
    .summary = Points == 8    ? "blocker search, 8 points of a nearest-texel sampler"
               : Points == 16 ? "blocker search, 16 points of a nearest-texel sampler"
                              : "blocker search, 32 points of a nearest-texel sampler",
    .exactness = tier::c,
    .operations = 24,
    .needs = list<&in_filter_domain, &blocker_at>,
    .source = {detail::blockers_hardware_text, Points}};

inline constexpr const snippet* pcss_hardware_snippets[]{&blocker_at, &pcss_radius, &blockers_hardware<8>,
                                                         &blockers_hardware<16>, &blockers_hardware<32>};

}  // namespace glsl
}  // namespace umbrage
