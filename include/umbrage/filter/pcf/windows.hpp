// SPDX-License-Identifier: MIT
//
// Sliding PCF kernels of this library, as functions and as values of one filter.
//
//     float visibility = umbrage::binomial<5>(umbrage::bordered(map), coord, depth - bias);
//     umbrage::visibility(map, encoding, receivers, umbrage::filters::binomial<5>, out);
//
//     tent<2>, tent<3>, tent<7>    1 1; 1 2 1; 1 2 3 4 3 2 1
//     binomial<5>, binomial<7>     1 4 6 4 1; 1 6 15 20 15 6 1. Close to a Gaussian of 1.1 and 1.3 texels
//     castano<5>, castano<7>       1 3 4 3 1; 1 5 12 16 12 5 1. Shaders merge them into 9 and 16 filtered comparisons
//     castano_dyadic<5>            5 16 22 16 5. Within 1.7 % of castano<5>, but exact. For castano<7> use binomial<7>
//     quadratic_b_spline           of 3 x 3 texels, edges without a kink
//
// Also called: Gaussian PCF (binomial); Castano's PCF, The Witness PCF, optimized PCF (castano); tent filter, 3x3 PCF
// (tent).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>

#include <umbrage/core/check.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/window.hpp>

namespace umbrage {

/// Row of tent weights: each differs from its neighbors by one step. All rows here are in sixteenths where that makes
/// their sum a power of two.
template <int Size>
inline constexpr window_row tent_row = [] {
    static_assert(Size == 2 || Size == 3 || Size == 7, "of other sizes the weights add up to no power of two");
    constexpr float step = Size == 2 ? 8.0f : (Size == 3 ? 4.0f : 1.0f);
    return make_window_row(Size, {step, 2 * step, 3 * step, 4 * step});
}();

/// Row of binomial coefficients.
template <int Size>
inline constexpr window_row binomial_row = [] {
    static_assert(Size == 5 || Size == 7);
    return Size == 5 ? make_window_row(5, {1, 4, 6}) : make_window_row(7, {0.25f, 1.5f, 3.75f, 5});
}();

/// Row of Castano's weights, whose sums are 12 and 52.
template <int Size>
inline constexpr window_row castano_row = [] {
    static_assert(Size == 5 || Size == 7);
    return Size == 5 ? make_window_row(5, {1, 3, 4}) : make_window_row(7, {1, 5, 12, 16}, 64);
}();

/// Row 5 16 22 16 5.
template <int Size>
inline constexpr window_row castano_dyadic_row = [] {
    static_assert(Size == 5);
    return make_window_row(5, {1.25f, 4, 5.5f});
}();

/// Row of the quadratic B-spline: weights (1 - f)^2 / 2, 3/4 - (f - 1/2)^2 and f^2 / 2 within 3.9e-4.
inline constexpr window_row quadratic_b_spline_row = [] {
    window_row row = make_window_row(2, {8});
    row.quadratic = true;
    return row;
}();

/// PCF under a tent: window() with tent_row. Parameters and result as for window(), without the row.
/// @exactness   A
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T tent(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, tent_row<Size>, is_lit);
}
/// PCF under a binomial kernel: window() with binomial_row.
/// @exactness   A
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T binomial(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, binomial_row<Size>, is_lit);
}
/// PCF under Castano's kernel: window() with castano_row.
/// @exactness   B, n = 80 or 138, S = 1: window_sum is exact, its product with 1 / 144 or 1 / 2704 rounds once
/// @cite        Castano: Shadow mapping summary, part 1, 2013
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T castano(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, castano_row<Size>, is_lit);
}
/// PCF under a kernel close to Castano's, but exact: window() with castano_dyadic_row.
/// @exactness   A
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T castano_dyadic(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, castano_dyadic_row<Size>, is_lit);
}
/// PCF under the quadratic B-spline: window() with quadratic_b_spline_row.
/// @exactness   A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T quadratic_b_spline(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, quadratic_b_spline_row, is_lit);
}

namespace glsl {
namespace detail {

/// Shader text of a row: window_sum with the row's numbers, then the scale.
[[nodiscard]] inline std::string window_text(std::string_view name, int size, std::string_view weights,
                                             std::string_view numbers,
                                             std::string_view share = "clamp(n * (1.0 / 16777216.0), 0.0, 1.0)") {
    return filled(R"GLSL(
// umbrage_$f$n: PCF under $n x $n weights, $w, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_$f$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum$n(map, size, coord, receiver, $k);
    return $s;
}
)GLSL",
                  {{'f', 0, name}, {'n', size}, {'w', 0, weights}, {'k', 0, numbers}, {'s', 0, share}});
}

/// Shader text of a kernel over 3 x 3 texels. before and behind are the neighbors' weights, in 1/4096.
[[nodiscard]] inline std::string text_3x3(std::string_view name, std::string_view what, std::string_view before,
                                          std::string_view behind) {
    return filled(R"GLSL(
// umbrage_$f: PCF over 3 x 3 texels, $w. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_$f(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                               UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    UMBRAGE_HIGHP vec2 s = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0)) * 256.0;
    UMBRAGE_HIGHP vec2 r = 256.0 - s;
    UMBRAGE_HIGHP vec2 w0 = $b;
    UMBRAGE_HIGHP vec2 w2 = $e;
    UMBRAGE_HIGHP vec2 w1 = max(4096.0 - w0 - w2, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, texel + vec2(1.0, -1.0), receiver);
    UMBRAGE_HIGHP vec4 c = umbrage_lit_2x2(map, size, texel + vec2(-1.0, 1.0), receiver);
    UMBRAGE_HIGHP vec4 d = umbrage_lit_2x2(map, size, texel + vec2(1.0, 1.0), receiver);
    UMBRAGE_HIGHP float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
)GLSL",
                  {{'f', 0, name}, {'w', 0, what}, {'b', 0, before}, {'e', 0, behind}});
}

/// Snippets that a family's texts need, by the size of the kernel.
template <int Size>
inline constexpr const auto& window_needs = list<&window_sum<Size>>;
template <>
inline constexpr const auto& window_needs<2> = list<&in_filter_domain, &lit_2x2>;

}  // namespace detail

/// GLSL text of tent<size>.
/// @param size   2, 3 or 7
[[nodiscard]] inline std::string tent_text(int size) {
    if (size == 2) return detail::text_3x3("tent2", "weights 1 1", "r * 8.0", "s * 8.0");
    if (size == 3) return detail::window_text("tent", 3, "1 2 1", "256.0, 4.0, 8.0");
    return detail::window_text("tent", 7, "1 2 3 4 3 2 1", "256.0, 1.0, 2.0, 3.0, 4.0");
}
template <int Size>
inline constexpr snippet tent{
    .name = Size == 2 ? "tent2" : (Size == 3 ? "tent3" : "tent7"),
    .summary = Size == 2 ? "PCF kernel 1 1" : (Size == 3 ? "PCF kernel 1 2 1" : "PCF kernel 1 2 3 4 3 2 1"),
    .exactness = tier::a,
    .needs = detail::window_needs<Size>,
    .source = {tent_text, Size}};

/// GLSL text of binomial<size>.
/// @param size   5 or 7
[[nodiscard]] inline std::string binomial_text(int size) {
    return size == 5 ? detail::window_text("binomial", 5, "1 4 6 4 1", "256.0, 1.0, 4.0, 6.0")
                     : detail::window_text("binomial", 7, "1 6 15 20 15 6 1", "256.0, 0.25, 1.5, 3.75, 5.0");
}
template <int Size>
inline constexpr snippet binomial{.name = Size == 5 ? "binomial5" : "binomial7",
                                  .summary = Size == 5 ? "PCF kernel 1 4 6 4 1" : "PCF kernel 1 6 15 20 15 6 1",
                                  .exactness = tier::a,
                                  .needs = detail::window_needs<Size>,
                                  .source = {binomial_text, Size}};

/// GLSL text of castano<size>.
/// @param size   5 or 7
[[nodiscard]] inline std::string castano_text(int size) {
    return size == 5 ? detail::window_text("castano", 5, "1 3 4 3 1", "256.0, 1.0, 3.0, 4.0",
                                           "n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0")
                     : detail::window_text("castano", 7, "1 5 12 16 12 5 1", "64.0, 1.0, 5.0, 12.0, 16.0",
                                           "n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0");
}
template <int Size>
inline constexpr snippet castano{.name = Size == 5 ? "castano5" : "castano7",
                                 .summary = Size == 5 ? "PCF kernel 1 3 4 3 1" : "PCF kernel 1 5 12 16 12 5 1",
                                 .exactness = tier::b,
                                 .operations = Size == 5 ? 80 : 138,
                                 .needs = detail::window_needs<Size>,
                                 .source = {castano_text, Size}};

/// GLSL text of castano_dyadic<5>.
template <int Size>
[[nodiscard]] std::string castano_dyadic_text() {
    return detail::window_text("castano_dyadic", 5, "5 16 22 16 5", "256.0, 1.25, 4.0, 5.5");
}
template <int Size>
inline constexpr snippet castano_dyadic{.name = "castano_dyadic5",
                                        .summary = "PCF kernel 5 16 22 16 5",
                                        .exactness = tier::a,
                                        .needs = detail::window_needs<Size>,
                                        .source = castano_dyadic_text<Size>};

/// GLSL text of quadratic_b_spline.
[[nodiscard]] inline std::string quadratic_b_spline_text() {
    return detail::text_3x3("quadratic_b_spline", "weighted by the quadratic B-spline", "floor(r * r * (1.0 / 32.0))",
                            "floor(s * s * (1.0 / 32.0))");
}
inline constexpr snippet quadratic_b_spline{.name = "quadratic_b_spline",
                                            .summary = "PCF kernel of the quadratic B-spline, 3x3 texels",
                                            .exactness = tier::a,
                                            .needs = detail::window_needs<2>,
                                            .source = quadratic_b_spline_text};

}  // namespace glsl

namespace filters {

/// Sliding PCF kernel as a value: one of this library's below, or one with your own row.
struct window {
    window_row row = tent_row<3>;
    depth_direction direction = depth_direction::forward;
    std::string_view name = "window";
    const glsl::snippet* snippet = nullptr;  ///< returns the same result; none for your own rows

    static const std::array<window, 9> values;  ///< kernels of this library

    /// @throws std::invalid_argument  a row that make_window_row never makes, in the name of `function`
    void check(std::string_view function) const {
        detail::require(detail::is_made_row(row), function, "filter.row", "of make_window_row", row.size,
                        "That is its size; its weights, steps and whole count, too.");
    }
    static constexpr std::tuple<> numbers(auto&) { return {}; }
    [[nodiscard]] constexpr float reach() const { return row.reach(); }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::window(fetch, coord, receiver, row, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

template <int Size>
inline constexpr window tent{tent_row<Size>, {}, glsl::tent<Size>.name, &glsl::tent<Size>};
template <int Size>
inline constexpr window binomial{binomial_row<Size>, {}, glsl::binomial<Size>.name, &glsl::binomial<Size>};
template <int Size>
inline constexpr window castano{castano_row<Size>, {}, glsl::castano<Size>.name, &glsl::castano<Size>};
template <int Size>
inline constexpr window castano_dyadic{
    castano_dyadic_row<Size>, {}, glsl::castano_dyadic<Size>.name, &glsl::castano_dyadic<Size>};
inline constexpr window quadratic_b_spline{
    quadratic_b_spline_row, {}, glsl::quadratic_b_spline.name, &glsl::quadratic_b_spline};

inline constexpr std::array<window, 9> window::values{
    tent<2>, tent<3>, quadratic_b_spline, binomial<5>, castano_dyadic<5>, castano<5>, binomial<7>, tent<7>, castano<7>};

}  // namespace filters
}  // namespace umbrage
