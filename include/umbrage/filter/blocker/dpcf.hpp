// SPDX-License-Identifier: MIT
//
// Contact hardening without a second look: one disc counts the blockers, and its share is steepened to the penumbra's
// width. Half the texels of pcss, and softer than it where a penumbra is much narrower than the light.
//
//     float visibility = umbrage::dpcf<16>(umbrage::bordered(map), coord, depth - bias, glm::vec3(soft),
//                                          umbrage::disc_rotation(pixel));
//
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <umbrage/core/lesser.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

/// The share of a disc in shadow, steepened.
/// @tparam Points    8, 16 or 32
/// @param blocked    whole, 0 .. Points
/// @param ratio      of the penumbra to the disc, in 1/256, whole, 0 .. 256: 256 leaves the share as it is
/// @return           0 lit .. 1; 0, 1/2 and 1 stay what they are, and more blocked is never less dark
/// @formula          x = blocked / Points, s the sign of 2 x - 1: 1/2 + s/2 (1 - (1 - |2 x - 1|)^3), which ratio mixes
///                   with x
/// @exactness        A: whole numbers up to 2^24, over 512 Points^3
/// @cite             Google Filament: surface_shadowing.fs
template <int Points, real T>
[[nodiscard]] constexpr T hardened_kernel(T blocked, T ratio) {
    constexpr T n = T(Points), cube = n * n * n;
    const T u = blocked * T(2) - n, d = n - (u < T(0) ? -u : u), steep = cube - d * d * d;
    const T hard = u < T(0) ? cube - steep : cube + steep;
    return (hard * (T(256) - ratio) + blocked * ratio * (T(2) * n * n)) * (T(1) / (T(512) * cube));
}

/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called Points times, texels may lie the widest radius outside the map
/// @param coord      receiver in texels, the first texel's center is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param softness   of make_penumbra_params: (per_code, min_radius, max_radius)
/// @param rotation   as disc_rotation gives it
/// @return           visibility, 1 where nothing blocks, 0 where all does
/// @formula          z = distance_code(receiver); m blockers with the sum s within w = penumbra(z);
///                   1 - hardened_kernel(m, floor(256 penumbra(z - floor(s / m)) / w))
/// @exactness        A
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T dpcf(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<3, T> softness, glm::vec<2, T> rotation,
                     Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const T z = distance_code(receiver, is_lit), search_radius = penumbra(z, softness);
    const glm::vec<2, T> found =
        blockers<Points>(fetch, glm::floor(coord * T(256)), receiver, search_radius, rotation, is_lit);
    const T mean = floor_divide(found.y, detail::greater(found.x, T(1)));
    const T ratio = floor_divide(penumbra(z - mean, softness) * T(256), detail::greater(search_radius, T(1)));
    return T(1) - hardened_kernel<Points>(found.x, ratio);
}

namespace glsl {
namespace detail {

[[nodiscard]] inline std::string hardened_kernel_text(int points) {
    const int n = points;
    return filled(R"GLSL(
// umbrage_hardened_kernel$n: the share of $n points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
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
// umbrage_dpcf$n: contact hardening by $n points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_dpcf$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers$n(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    UMBRAGE_HIGHP float ratio = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
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
    .summary = "a disc's share in shadow, steepened",
    .exactness = tier::a,
    .source = {detail::hardened_kernel_text, Points}};

template <int Points>
inline constexpr snippet dpcf{
    .name = Points == 8 ? "dpcf8" : (Points == 16 ? "dpcf16" : "dpcf32"),
    .summary = Points == 8    ? "contact hardening by 8 points"
               : Points == 16 ? "contact hardening by 16 points"
                              : "contact hardening by 32 points",
    .exactness = tier::a,
    .needs =
        list<&in_filter_domain, &distance_code, &penumbra, &blockers<Points>, &floor_divide, &hardened_kernel<Points>>,
    .source = {detail::dpcf_text, Points}};

inline constexpr const snippet* dpcf_snippets[]{
    &hardened_kernel<8>, &hardened_kernel<16>, &hardened_kernel<32>, &dpcf<8>, &dpcf<16>, &dpcf<32>};

}  // namespace glsl

namespace filters {

/// The filter as a value; functions over images turn it from pixel to pixel.
struct dpcf {
    int points = 16;  ///< 8, 16 or 32
    penumbra_params softness{};
    comparison is_lit{};
    const glsl::snippet* snippet = points == 8 ? &glsl::dpcf<8> : points == 16 ? &glsl::dpcf<16> : &glsl::dpcf<32>;
    std::string_view name = snippet->name;

    static const std::array<dpcf, 3> values;

    /// The disc of the widest radius.
    [[nodiscard]] constexpr disc largest_disc() const { return {points, softness.max_radius * 0.0625f, is_lit}; }
    /// From a receiver to the farthest point, in texels.
    [[nodiscard]] constexpr float farthest_point() const { return largest_disc().farthest_point(); }
    [[nodiscard]] constexpr float reach() const { return largest_disc().reach(); }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        const glm::vec2 rotation = disc_rotation(glm::vec2(pixel));
        const glm::vec3 soft(softness);
        if (points == 8) return umbrage::dpcf<8>(fetch, coord, receiver, soft, rotation, is_lit);
        if (points == 16) return umbrage::dpcf<16>(fetch, coord, receiver, soft, rotation, is_lit);
        return umbrage::dpcf<32>(fetch, coord, receiver, soft, rotation, is_lit);
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

inline constexpr std::array<dpcf, 3> dpcf::values{{{.points = 8}, {.points = 16}, {.points = 32}}};

}  // namespace filters
}  // namespace umbrage
