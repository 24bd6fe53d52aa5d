// SPDX-License-Identifier: MIT
//
// Soft shadows with contact hardening from one pass over a disc (DPCF), as in Filament.
//
//     float visibility = umbrage::dpcf<16>(umbrage::bordered(map), coord, depth - bias, glm::vec4(soft),
//                                          umbrage::disc_rotation(pixel));
//
// It counts the blockers under the disc, and steepens that fraction to the penumbra's width. It reads half the texels
// of pcss. It is for large casters far from what they shadow. It darkens lit walls beside inner corners where the
// penumbra is much narrower than the disc. It lets light through at contact there.
// Also called: DPCF.
// See also: pcss.hpp.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include <glm/common.hpp>

#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/disc.hpp>

namespace umbrage {

/// Fraction of a disc in shadow, steepened to the width of the penumbra.
/// @tparam Points    8, 16 or 32
/// @param blocked    number of blockers, an integer, 0 .. Points
/// @param ratio      width of the penumbra over that of the disc, in 1/256: an integer, 0 .. 256. 256 changes nothing
/// @return           0 lit .. 1 in shadow. 0, 1/2 and 1 stay as they are. More blockers never give a lighter result
/// @formula          x = blocked / Points, s the sign of 2 x - 1: 1/2 + s/2 (1 - (1 - |2 x - 1|)^3), which ratio blends
///                   with x
/// @exactness        A: integers up to 2^24, over 512 Points^3
/// @cite             Google Filament: surface_shadowing.fs
template <int Points, real T>
[[nodiscard]] constexpr T hardened_kernel(T blocked, T ratio) {
    constexpr T n = T(Points), cube = n * n * n;
    const T u = blocked * T(2) - n, d = n - (u < T(0) ? -u : u), steep = cube - d * d * d;
    const T hard = u < T(0) ? cube - steep : cube + steep;
    return (hard * (T(256) - ratio) + blocked * ratio * (T(2) * n * n)) * (T(1) / (T(512) * cube));
}

/// Visibility of a receiver under a light that has a size, from one pass over a disc.
/// @tparam Points    8, 16 or 32
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called Points times, with indices up to
///                   softness.w / 16 texels outside the map. Depth must be z/w, not linear
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param softness   (per_code_x, per_code_y, min_radius, max_radius), from make_penumbra_params
/// @param rotation   from disc_rotation. Trades banding for noise
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 1 where nothing blocks, 0 where every point blocks
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0. softness
///                   out of range or NaN: from 0 to 1
/// @formula          z = distance_code(receiver); m blockers with the sum s within w = penumbra(z);
///                   1 - hardened_kernel(m, floor(256 penumbra(z - floor(s / m)) / w)),
///                   where a radius counts as the sum of its x and y
/// @exactness        A
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T dpcf(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<4, T> softness, glm::vec<4, T> rotation,
                     Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const T z = distance_code(receiver, is_lit);
    const glm::vec<2, T> search_radius = penumbra(z, softness);
    const glm::vec<2, T> found =
        blockers<Points>(fetch, glm::floor(coord * T(256)), receiver, search_radius, rotation, is_lit);
    const glm::vec<2, T> radius = penumbra(z - floor_divide(found.y, (glm::max)(found.x, T(1))), softness);
    const T ratio = floor_divide((radius.x + radius.y) * T(256), (glm::max)(search_radius.x + search_radius.y, T(1)));
    return saturate(T(1) - hardened_kernel<Points>(found.x, ratio));
}

namespace glsl {
namespace detail {

[[nodiscard]] inline std::string hardened_kernel_text(int points) {
    const int n = points;
    return filled(R"GLSL(
// umbrage_hardened_kernel$n: fraction of $n points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
UMBRAGE_HIGHP float umbrage_hardened_kernel$n(UMBRAGE_HIGHP float blocked, UMBRAGE_HIGHP float ratio) {
    UMBRAGE_HIGHP float u = blocked * 2.0 - $n.0;
    UMBRAGE_HIGHP float d = max($n.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float steep = $c.0 - d * d * d;
    UMBRAGE_HIGHP float hard = u < 0.0 ? $c.0 - steep : $c.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * $s.0) * (1.0 / $w.0);
}
)GLSL",
                  {{'n', n}, {'c', n * n * n}, {'s', 2 * n * n}, {'w', 512 * n * n * n}});
}

[[nodiscard]] inline std::string dpcf_text(int points) {
    return filled(R"GLSL(
// umbrage_dpcf$n: soft shadow with contact hardening from $n points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_dpcf$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec4 softness,
                                   UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP vec2 search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers$n(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP vec2 radius = umbrage_penumbra(z - mean, softness);
    UMBRAGE_HIGHP float searched = max(search_radius.x + search_radius.y, 1.0);
    UMBRAGE_HIGHP float ratio = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    UMBRAGE_HIGHP float dark = umbrage_hardened_kernel$n(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
)GLSL",
                  {{'n', points}});
}

}  // namespace detail

template <int Points>
inline constexpr snippet hardened_kernel{
    .name = Points == 8 ? "hardened_kernel8" : (Points == 16 ? "hardened_kernel16" : "hardened_kernel32"),
    .summary = "fraction of a disc in shadow, steepened",
    .exactness = tier::a,
    .source = {detail::hardened_kernel_text, Points}};

template <int Points>
inline constexpr snippet dpcf{
    .name = Points == 8 ? "dpcf8" : (Points == 16 ? "dpcf16" : "dpcf32"),
    .summary = Points == 8    ? "contact hardening from one pass (DPCF), 8 points"
               : Points == 16 ? "contact hardening from one pass (DPCF), 16 points"
                              : "contact hardening from one pass (DPCF), 32 points",
    .exactness = tier::a,
    .needs =
        list<&in_filter_domain, &distance_code, &penumbra, &blockers<Points>, &floor_divide, &hardened_kernel<Points>>,
    .source = {detail::dpcf_text, Points}};

inline constexpr const snippet* dpcf_snippets[]{
    &hardened_kernel<8>, &hardened_kernel<16>, &hardened_kernel<32>, &dpcf<8>, &dpcf<16>, &dpcf<32>};

}  // namespace glsl

namespace filters {

/// DPCF filter as a value. Functions over images rotate its disc per pixel.
struct dpcf {
    int points = 16;             ///< 8, 16 or 32, as disc's
    penumbra_params softness{};  ///< from make_penumbra_params. A shadow wants one with a light_size
    depth_direction direction = depth_direction::forward;
    const glsl::snippet* snippet = points == 8 ? &glsl::dpcf<8> : points == 16 ? &glsl::dpcf<16> : &glsl::dpcf<32>;
    std::string_view name = snippet->name;

    static const std::array<dpcf, 3> values;
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
        if (points == 8) return umbrage::dpcf<8>(fetch, coord, receiver, soft, rotation, comparison{direction});
        if (points == 16) return umbrage::dpcf<16>(fetch, coord, receiver, soft, rotation, comparison{direction});
        return umbrage::dpcf<32>(fetch, coord, receiver, soft, rotation, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

inline constexpr std::array<dpcf, 3> dpcf::values{{{.points = 8}, {.points = 16}, {.points = 32}}};

}  // namespace filters
}  // namespace umbrage
