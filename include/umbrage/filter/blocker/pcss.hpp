// SPDX-License-Identifier: MIT
//
// Percentage-closer soft shadows (PCSS): sharp where a caster touches the receiver, softer with distance.
//
//     umbrage::penumbra_params soft = umbrage::make_penumbra_params(light, map.size(), light_radius);
//     float visibility = umbrage::pcss<16>(umbrage::bordered(map), coord, depth - bias, glm::vec4(soft),
//                                          umbrage::disc_rotation(pixel));
//
// 1. Search a disc for texels nearer to the light (blockers). It is as wide as the light appears from the receiver.
// 2. Their mean distance gives the width of the penumbra.
// 3. Filter over a disc of that width.
// Search and filter share points, rotation and bias. A bias without acne at the largest radius has no acne at any
// radius, but it is too large for most receivers. Under eaves, casters are nearer to the wall than the bias. Only some
// rotations of the disc then find a blocker, and the shadow breaks into stripes. Receiver plane depth bias
// (receiver_plane.hpp) avoids this. Half a texel of bias is then enough for any radius.
// Also called: contact hardening, PCSS, variable penumbra, area light shadows. Cheaper: dpcf.hpp, pcss_hardware.hpp.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/disc.hpp>

namespace umbrage {

/// Visibility of a receiver under a light that has a size.
/// @tparam Points    8, 16 or 32: texels read by the search, and again by the filter
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called 2 * Points times, with indices up
///                   to softness.w / 16 texels outside the map. Depth must be z/w, not linear
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param softness   (per_code_x, per_code_y, min_radius, max_radius), from make_penumbra_params
/// @param rotation   from disc_rotation. Trades banding for noise
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]. A multiple of 1 / Points
/// @edge             no blocker found, as for a receiver at the near plane: 1. Blockers at every point: the filter
///                   decides. coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0.
///                   softness out of range or NaN: of a radius from 0 to 255.9375 texels
/// @formula          z = distance_code(receiver); m blockers with the sum s within penumbra(z);
///                   ellipse(penumbra(z - floor(s / m)))
/// @accuracy         the radius is off by -(1 + c) to 2 c sixteenths of a texel, c = per_code of its axis, since
///                   depths are rounded down to 16 bits. It is also off by 1/256 of itself, as per_code is rounded
/// @exactness        A
/// @cite             Fernando: Percentage-closer soft shadows, SIGGRAPH 2005 sketches
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcss(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<4, T> softness, glm::vec<4, T> rotation,
                     Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const T z = distance_code(receiver, is_lit);
    const glm::vec<2, T> found =
        blockers<Points>(fetch, glm::floor(coord * T(256)), receiver, penumbra(z, softness), rotation, is_lit);
    if (!(found.x > T(0))) return T(1);
    const glm::vec<2, T> radius = penumbra(z - floor_divide(found.y, found.x), softness);
    return ellipse<Points>(fetch, coord, receiver, radius, rotation, is_lit);
}

namespace glsl {
namespace detail {

[[nodiscard]] inline std::string pcss_text(int points) {
    return filled(R"GLSL(
// umbrage_pcss$n: percentage-closer soft shadows (PCSS), $n points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_pcss$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec4 softness,
                                   UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP vec2 search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers$n(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP vec2 radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse$n(map, size, coord, receiver, radius, rotation);
}
)GLSL",
                  {{'n', points}});
}

}  // namespace detail

template <int Points>
inline constexpr snippet pcss{
    .name = Points == 8 ? "pcss8" : (Points == 16 ? "pcss16" : "pcss32"),
    .summary = Points == 8    ? "percentage-closer soft shadows (PCSS), 8 points twice"
               : Points == 16 ? "percentage-closer soft shadows (PCSS), 16 points twice"
                              : "percentage-closer soft shadows (PCSS), 32 points twice",
    .exactness = tier::a,
    .needs = list<&in_filter_domain, &distance_code, &penumbra, &blockers<Points>, &floor_divide, &ellipse<Points>>,
    .source = {detail::pcss_text, Points}};

inline constexpr const snippet* pcss_snippets[]{&pcss<8>, &pcss<16>, &pcss<32>};

}  // namespace glsl

namespace filters {

/// PCSS filter as a value. Functions over images rotate its discs per pixel.
struct pcss {
    int points = 16;             ///< 8, 16 or 32, as disc's
    penumbra_params softness{};  ///< from make_penumbra_params. A shadow wants one with a light_size
    depth_direction direction = depth_direction::forward;
    const glsl::snippet* snippet = points == 8 ? &glsl::pcss<8> : points == 16 ? &glsl::pcss<16> : &glsl::pcss<32>;
    std::string_view name = snippet->name;

    static const std::array<pcss, 3> values;
    static constexpr auto numbers(auto& f) { return std::tie(f.softness); }

    /// @throws std::invalid_argument  points other than 8, 16 and 32, or a softness that make_penumbra_params never
    ///                                makes, in the name of `function`
    void check(std::string_view function) const {
        largest_disc().check(function);
        detail::require_softness(function, softness);
    }
    /// Disc of the largest radius.
    [[nodiscard]] constexpr disc largest_disc() const { return {points, softness.max_radius * 0.0625f, direction}; }
    /// Distance from a receiver to the farthest point, in texels.
    [[nodiscard]] constexpr float farthest_point() const { return largest_disc().farthest_point(); }
    [[nodiscard]] constexpr float reach() const { return largest_disc().reach(); }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        return rotated(fetch, coord, receiver, disc_rotation(glm::vec2(pixel)));
    }
    /// The filter by a rotation of its disc.
    template <class Fetch>
    [[nodiscard]] float rotated(Fetch&& fetch, glm::vec2 coord, float receiver, glm::vec4 rotation) const {
        const glm::vec4 soft(softness);
        if (points == 8) return umbrage::pcss<8>(fetch, coord, receiver, soft, rotation, comparison{direction});
        if (points == 16) return umbrage::pcss<16>(fetch, coord, receiver, soft, rotation, comparison{direction});
        return umbrage::pcss<32>(fetch, coord, receiver, soft, rotation, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

inline constexpr std::array<pcss, 3> pcss::values{{{.points = 8}, {.points = 16}, {.points = 32}}};

}  // namespace filters
}  // namespace umbrage
