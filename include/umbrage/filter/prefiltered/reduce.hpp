// SPDX-License-Identifier: MIT
//
// Blur and mip chain of prefiltered maps, as shader passes: each pass reads one map and writes another. `blur()` and
// `make_mip_chain()` over images give the same bits.
//
//     out_texel = umbrage_blur_row5(map, size, texel, vec2(0.0, 1.0));  // first along y, into a second map,
//     out_texel = umbrage_blur_row5(map, size, texel, vec2(1.0, 0.0));  // then that map along x
//
#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {
namespace detail {

/// Binomial coefficient in row taps - 1 of Pascal's triangle, at a distance from the row's center.
[[nodiscard]] constexpr int binomial_weight(int taps, int distance) {
    int weight = 1;
    for (int i = 0; i < taps / 2 - distance; ++i) weight = weight * (taps - 1 - i) / (i + 1);
    return weight;
}

}  // namespace detail

/// Mean of texels in a row, with the weights of a row of Pascal's triangle.
/// @param fetch     returns a texel, float or vector, from glm::ivec2. Called Taps times, also for texels outside the
///                  map
/// @param texel     index of the central texel, integers
/// @param step      (1, 0) along x, (0, 1) along y
/// @formula         w0 c + w1 (before1 + after1) + ..., in this order,
///                  w_i = C(Taps - 1, (Taps - 1) / 2 + i) / 2^(Taps - 1)
/// @exactness       B, n = 7, 12, 17 of 3, 5, 7 taps;  A for 5 taps along both axes, over multiples of 2^-16 below 1
template <int Taps, class Fetch>
[[nodiscard]] auto blur_row(Fetch&& fetch, glm::ivec2 texel, glm::ivec2 step) {
    static_assert(Taps == 3 || Taps == 5 || Taps == 7);
    const auto weight = [](int i) {
        return static_cast<float>(detail::binomial_weight(Taps, i)) / static_cast<float>(1 << (Taps - 1));
    };
    auto sum = fetch(texel) * weight(0);
    for (int i = 1; i <= Taps / 2; ++i) sum = sum + (fetch(texel - step * i) + fetch(texel + step * i)) * weight(i);
    return sum;
}

/// Mean of the 2x2 texels behind one texel of the next mip level.
/// @param fetch     returns a texel, float or vector, from glm::ivec2. Called 4 times
/// @param texel     index in the next level. If a level's size is odd, its last column or row counts twice
/// @formula         ((a + b) + (c + d)) / 4
/// @exactness       B, n = 8;  A for multiples of 2^-22 below 1
template <class Fetch>
[[nodiscard]] auto halve_texels(Fetch&& fetch, glm::ivec2 texel) {
    const glm::ivec2 at = texel * 2;
    const auto a = fetch(at), b = fetch(at + glm::ivec2(1, 0));
    const auto c = fetch(at + glm::ivec2(0, 1)), d = fetch(at + glm::ivec2(1, 1));
    return ((a + b) + (c + d)) * 0.25f;
}

namespace glsl {

/// Name of the snippet of blur_row<Taps>.
template <int Taps>
inline constexpr detail::short_name blur_row_name("blur_row$n", {{'n', Taps}});
/// GLSL text of blur_row<taps>.
/// @param taps   3, 5 or 7
[[nodiscard]] inline std::string blur_row_text(int taps) {
    std::string out =
        detail::filled(R"GLSL(
// umbrage_blur_row$n: mean of $n texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
UMBRAGE_HIGHP vec4 umbrage_blur_row$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                     UMBRAGE_HIGHP vec2 along) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = umbrage_fetch_clamped(map, size, texel) * ($w.0 / $d.0);
)GLSL",
                       {{'n', taps}, {'w', umbrage::detail::binomial_weight(taps, 0)}, {'d', 1 << (taps - 1)}});
    for (int i = 1; i <= taps / 2; ++i)
        detail::append(out,
                       R"GLSL(    UMBRAGE_HIGHP vec4 before$i = umbrage_fetch_clamped(map, size, texel - along * $i.0);
    UMBRAGE_HIGHP vec4 after$i = umbrage_fetch_clamped(map, size, texel + along * $i.0);
    sum = sum + (before$i + after$i) * ($w.0 / $d.0);
)GLSL",
                       {{'i', i}, {'w', umbrage::detail::binomial_weight(taps, i)}, {'d', 1 << (taps - 1)}});
    out += "    return sum;\n}\n";
    return out;
}
template <int Taps>
inline constexpr snippet blur_row{.name = blur_row_name<Taps>.view(),
                                  .summary = "binomial mean of texels in a row, for blurs",
                                  .exactness = tier::b,
                                  .operations = (5 * Taps - 1) / 2,
                                  .needs = list<&fetch_clamped>,
                                  .source = {blur_row_text, Taps}};

inline constexpr snippet halve_texels{
    .name = "halve_texels",
    .summary = "mean of 2x2 texels, for mip chains",
    .exactness = tier::b,
    .operations = 8,
    .needs = list<&fetch_clamped>,
    .source = R"GLSL(
// umbrage_halve_texels: mean of the 2x2 texels behind one texel of the next mip level
//   map, size   map that is read, and its size in texels
//   texel       index in the next level, integers
UMBRAGE_HIGHP vec4 umbrage_halve_texels(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel * 2.0;
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, at);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, at + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, at + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, at + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
)GLSL",
};

inline constexpr const snippet* reduce_snippets[]{&blur_row<3>, &blur_row<5>, &blur_row<7>, &halve_texels};

}  // namespace glsl
}  // namespace umbrage
