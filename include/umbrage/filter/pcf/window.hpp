// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering under a window of weights that slides over the map in steps of 1/256 texel, so that
// edges of shadows move as smoothly as receivers do.
//
//     float visibility = umbrage::tent<3>(umbrage::bordered(map), coord, depth - bias);  // 1 2 1, 4 x 4 texels
//     constexpr umbrage::window_row row = umbrage::make_window_row(5, {1, 3, 8});
//     float softer = umbrage::window(umbrage::bordered(map), coord, depth - bias, row);  // 1 3 8 3 1, 6 x 6
//
// In a shader a window asks for 2 x 2 texels at a time: bound to a map with `gather`, one of 3 x 3 weights takes 4
// gathers, one of 5 x 5 takes 9, one of 7 x 7 takes 16.
//
// A window of n x n weights touches n + 1 texels an axis: each texel has its own weight and that of its neighbor, as
// much of either as the window has moved. The library's rows of weights are in windows.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

inline constexpr int max_window = 15;

/// A row of weights, the same along both axes, as make_window_row makes it.
struct window_row {
    int size;                   ///< how many weights
    std::array<float, 8> half;  ///< from the edge to the middle one; the others mirror them
    int steps;                  ///< of a texel
    float whole;                ///< what the touched texels' weights along an axis add up to: steps times their sum
    float scale;                ///< 1 / whole^2
    double scale_of_doubles;    ///< the same
    bool quadratic = false;     ///< of two weights, but those of the quadratic B-spline

    /// From one edge to the other, 0 beside the row.
    [[nodiscard]] constexpr float weight(int i) const {
        const int mirrored = i < size - 1 - i ? i : size - 1 - i;
        return mirrored < 0 ? 0.0f : half[static_cast<std::size_t>(mirrored)];
    }
    [[nodiscard]] constexpr int touched() const { return size + 1; }  ///< texels along an axis
    /// From a receiver to the farthest point of its texels, in texels; never attained.
    [[nodiscard]] constexpr float reach() const { return static_cast<float>(size + 1) * 0.5f; }
};

/// A row of weights from what is to be told of it.
/// @param size    weights, 1 .. 15
/// @param half    from the edge to the middle one: size / 2 of them, rounded up; none is negative
/// @param steps   of a texel, a power of two up to 256; times the sum of all weights it is a whole number up to 4096
/// @throws std::invalid_argument  anything else
[[nodiscard]] constexpr window_row make_window_row(int size, std::array<float, 8> half, int steps = 256) {
    constexpr auto function = "make_window_row";
    detail::require(size >= 1 && size <= max_window, function, "size", "from 1 to 15", size);
    detail::require(steps >= 1 && steps <= 256 && (steps & (steps - 1)) == 0, function, "steps",
                    "a power of two from 1 to 256", steps);
    float sum = 0.0f;
    for (int i = 0; i < size; ++i) {
        const float weight = half[static_cast<std::size_t>(i < size - 1 - i ? i : size - 1 - i)];
        detail::require(weight >= 0.0f, function, "half", "weights of 0 or more", weight);
        sum += weight;
    }
    const float whole = sum * static_cast<float>(steps);
    const bool integer = whole >= 1.0f && whole <= 4096.0f && whole == static_cast<float>(static_cast<int>(whole));
    detail::require(integer, function, "the sum of all weights times steps", "an integer from 1 to 4096", whole);
    return {size, half, steps, whole, 1.0f / (whole * whole), 1.0 / (double(whole) * double(whole))};
}

/// Weights of the texels that a window touches along an axis, whole numbers that add up to row.whole.
/// @param moved     by how much the window has moved, in 1/256 texel, 0 .. 255
/// @param weights   row.touched() of them
/// @formula         w_i = floor(K_i r + K_(i-1) s), s = moved, in steps of the row, r = steps - s; the middle one has
///                  what is left. Quadratic: floor((256 - s)^2 / 32), what is left, floor(s^2 / 32)
template <real T>
constexpr void window_weights(const window_row& row, int moved, T* weights) {
    const int steps = row.steps, s = moved * steps / 256, middle = row.size / 2, ahead = 256 - moved;
    int left = static_cast<int>(row.whole);
    for (int i = 0; i <= row.size; ++i) {
        if (i == middle) continue;
        int weight =
            static_cast<int>(row.weight(i) * static_cast<float>(steps - s) + row.weight(i - 1) * static_cast<float>(s));
        if (row.quadratic) weight = i == 0 ? ahead * ahead / 32 : moved * moved / 32;
        weights[i] = static_cast<T>(weight);
        left -= weight;
    }
    weights[middle] = static_cast<T>(left);
}

/// Weighted count of the lit texels under a window.
///
/// @param fetch      ivec2 texel -> stored depth; called row.touched()^2 times, texels may lie as far outside the map
///                   as half of them
/// @param coord      receiver in texels, the first texel's center is (0.5, 0.5); outside texel space, or NaN: all lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param row        as make_window_row makes it
/// @return           0 .. row.whole^2
/// @formula          sum of w_i w_j [receiver <= fetch(first + (i, j))], w by window_weights; first = texel - size / 2,
///                   where 256 texel + moved = floor(256 coord), less 128 for an odd size
/// @exactness        A: whole numbers up to 2^24
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window_sum(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row,
                           Compare is_lit = {}) {
    const T whole = static_cast<T>(row.whole);
    if (!in_filter_domain(coord, receiver, is_lit)) return whole * whole;
    const glm::vec<2, T> x = glm::floor(coord * T(256)) - T(row.size % 2 ? 128 : 0);
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0)), moved = x - texel * T(256);
    const glm::ivec2 first = glm::ivec2(texel) - row.size / 2;
    T columns[max_window + 1], rows[max_window + 1];
    window_weights(row, static_cast<int>(moved.x), columns);
    window_weights(row, static_cast<int>(moved.y), rows);
    T sum(0);
    for (int j = 0; j <= row.size; ++j) {
        T in_row(0);
        for (int i = 0; i <= row.size; ++i)
            in_row += columns[i] * lit(fetch, first + glm::ivec2(i, j), receiver, is_lit);
        sum += rows[j] * in_row;
    }
    return sum;
}

/// Lit share of a window; arguments as for window_sum.
/// @return        visibility: 0 in shadow, 1 lit
/// @formula       window_sum / row.whole^2
/// @exactness     A where row.whole is a power of two; else B: the sum is exact, its product with row.scale rounds once
/// @cite          Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row, Compare is_lit = {}) {
    const T sum = window_sum(fetch, coord, receiver, row, is_lit), whole = static_cast<T>(row.whole);
    if (!(sum < whole * whole)) return T(1);  // what a product of a rounded scale is only to nearest
    if constexpr (std::same_as<T, double>) return sum * row.scale_of_doubles;
    else return sum * row.scale;
}

namespace glsl {
namespace detail {

/// The parameter of a window's i-th weight.
constexpr int window_parameter(int size, int i) { return i < size - 1 - i ? i : size - 1 - i; }

/// What the i-th of the touched texels weighs, floors left aside.
[[nodiscard]] inline std::string window_weight(int size, int i) {
    const constant ahead{'a', window_parameter(size, i)}, behind{'b', window_parameter(size, i - 1)};
    return filled(i == 0 ? "r * k$a" : (i == size ? "s * k$b" : "r * k$a + s * k$b"), {ahead, behind});
}

[[nodiscard]] inline std::string window_sum_text(int size) {
    const int middle = size / 2;
    const char *const quads[] = {"a", "b", "c", "d"}, *const lanes[] = {"x", "y", "z", "w"};
    std::string text = filled(R"GLSL(
// umbrage_window_sum$n: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k$m   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
UMBRAGE_HIGHP float umbrage_window_sum$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                        UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float steps, UMBRAGE_HIGHP float k0,
                                        UMBRAGE_HIGHP float k1)GLSL",
                              {{'n', size}, {'m', middle}});
    for (int i = 2; i <= middle; ++i) append(text, ", UMBRAGE_HIGHP float k$i", {{'i', i}});
    text += R"GLSL() {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    UMBRAGE_HIGHP vec2 r = steps - s;
    UMBRAGE_HIGHP float whole = steps * (k0)GLSL";
    for (int i = 1; i < size; ++i) append(text, " + k$i", {{'i', window_parameter(size, i)}});
    text += ");\n";
    for (int i = 0; i <= size; ++i)
        if (i != middle)
            append(text, "    UMBRAGE_HIGHP vec2 w$i = floor($w);\n", {{'i', i}, {'w', 0, window_weight(size, i)}});
    append(text, "    UMBRAGE_HIGHP vec2 w$m = max(whole - (w0", {{'m', middle}});
    for (int i = 1; i <= size; ++i)
        if (i != middle) append(text, " + w$i", {{'i', i}});
    // not negative already; compilers cannot regroup the sum n across the max
    append(text,
           "), vec2(0.0, 0.0));\n    UMBRAGE_HIGHP vec2 first = texel - $m.0;\n    UMBRAGE_HIGHP float n = 0.0;\n",
           {{'m', middle}});
    for (int j = 0; j <= size; j += 2) {
        for (int i = 0; i <= size; i += 2)
            append(text, "    $t$a = umbrage_lit_2x2(map, size, first + vec2($i.0, $j.0), receiver);\n",
                   {{'t', 0, j == 0 ? "UMBRAGE_HIGHP vec4 " : ""}, {'a', 0, quads[i / 2]}, {'i', i}, {'j', j}});
        for (int row : {0, 1}) {
            append(text, "    n += w$j.y * (w0.x * a.$c", {{'j', j + row}, {'c', 0, lanes[2 * row]}});
            for (int i = 1; i <= size; ++i)
                append(text, " + w$i.x * $a.$c", {{'i', i}, {'a', 0, quads[i / 2]}, {'c', 0, lanes[2 * row + i % 2]}});
            text += ");\n";
        }
    }
    text += "    return compared ? n : whole * whole;\n}\n";
    return text;
}

}  // namespace detail

template <int Size>
inline constexpr snippet window_sum{.name = Size == 3 ? "window_sum3" : (Size == 5 ? "window_sum5" : "window_sum7"),
                                    .summary = Size == 3   ? "weighted count of lit texels under a window of 3 x 3"
                                               : Size == 5 ? "weighted count of lit texels under a window of 5 x 5"
                                                           : "weighted count of lit texels under a window of 7 x 7",
                                    .exactness = tier::a,
                                    .needs = list<&in_filter_domain, &lit_2x2>,
                                    .source = {detail::window_sum_text, Size}};

inline constexpr const snippet* window_snippets[]{&window_sum<3>, &window_sum<5>, &window_sum<7>};

}  // namespace glsl
}  // namespace umbrage
