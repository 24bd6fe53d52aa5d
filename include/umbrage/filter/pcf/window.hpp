// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) under a kernel of weights that slides over the map in steps of 1/256 texel. Shadow
// edges move as smoothly as the receivers do.
//
//     float visibility = umbrage::tent<3>(umbrage::bordered(map), coord, depth - bias);  // 1 2 1, 4 x 4 texels
//     constexpr umbrage::window_row row = umbrage::make_window_row(5, {1, 3, 8});
//     float softer = umbrage::window(umbrage::bordered(map), coord, depth - bias, row);  // 1 3 8 3 1, 6 x 6
//
// A shader reads 2 x 2 texels at a time. Bound to a map with `gather`, a kernel of 3 x 3 weights takes 4 gathers. 5 x 5
// takes 9, and 7 x 7 takes 16.
//
// A kernel of n x n weights touches n + 1 texels per axis. Each texel has a blend of two neighboring weights,
// in proportion to the distance that the kernel has moved.
// Also called: PCF kernel, weighted PCF. See also: windows.hpp, this library's rows of weights.
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

/// Largest width of a kernel, in texels.
inline constexpr int max_window = 15;

/// Row of kernel weights, the same along both axes. Make it with make_window_row.
struct window_row {
    int size;                   ///< number of weights
    std::array<float, 8> half;  ///< weights from the edge to the central one; the others mirror them
    int steps;                  ///< steps per texel
    float whole;              ///< sum of the touched texels' weights along an axis: steps times the sum of all weights
    float scale;              ///< 1 / whole^2
    double scale_of_doubles;  ///< the same, for T = double
    bool quadratic = false;   ///< weights of the quadratic B-spline, for rows of two weights only

    /// Weight i, counted from one edge to the other. 0 outside the row.
    [[nodiscard]] constexpr float weight(int i) const {
        const int mirrored = i < size - 1 - i ? i : size - 1 - i;
        return mirrored < 0 ? 0.0f : half[static_cast<std::size_t>(mirrored)];
    }
    [[nodiscard]] constexpr int touched() const { return size + 1; }  ///< texels along an axis
    /// Distance from a receiver to the farthest point of its texels, in texels. Never attained.
    [[nodiscard]] constexpr float reach() const { return static_cast<float>(size + 1) * 0.5f; }
};

namespace detail {

[[nodiscard]] constexpr bool is_row_size(int size) { return size >= 1 && size <= max_window; }
[[nodiscard]] constexpr bool is_row_steps(int steps) {
    return steps >= 1 && steps <= 256 && (steps & (steps - 1)) == 0;
}
/// An integer from 1 to 4096.
[[nodiscard]] constexpr bool is_row_whole(float whole) {
    return is_finite(whole) && whole >= 1.0f && whole <= 4096.0f &&
           whole == static_cast<float>(static_cast<int>(whole));
}

/// True if a row has numbers that make_window_row returns: then its weights are integers from 0 to whole.
[[nodiscard]] constexpr bool is_made_row(const window_row& row) {
    if (!is_row_size(row.size) || !is_row_steps(row.steps) || !is_row_whole(row.whole)) return false;
    if (row.quadratic && (row.size != 2 || row.whole != 4096.0f)) return false;
    float sum = 0.0f;
    for (int i = 0; i < row.size; ++i) {
        if (!is_finite(row.weight(i)) || row.weight(i) < 0.0f) return false;
        sum += row.weight(i);
    }
    const float off = sum * static_cast<float>(row.steps) - row.whole;
    return off > -0.5f && off < 0.5f;
}

}  // namespace detail

/// Row of kernel weights for window().
/// @param size    number of weights, 1 .. 15
/// @param half    weights from the edge to the central one, none negative: size / 2 of them, rounded up
/// @param steps   steps per texel, a power of two up to 256. Its product with the sum of all weights must be an integer
///                up to 4096
/// @throws std::invalid_argument  a parameter outside its range
[[nodiscard]] constexpr window_row make_window_row(int size, std::array<float, 8> half, int steps = 256) {
    constexpr auto function = "make_window_row";
    detail::require(detail::is_row_size(size), function, "size", "from 1 to 15", size);
    detail::require(detail::is_row_steps(steps), function, "steps", "a power of two from 1 to 256", steps);
    float sum = 0.0f;
    for (int i = 0; i < size; ++i) {
        const float weight = half[static_cast<std::size_t>(i < size - 1 - i ? i : size - 1 - i)];
        detail::require(weight >= 0.0f, function, "half", "weights of 0 or more", weight);
        sum += weight;
    }
    const float whole = sum * static_cast<float>(steps);
    detail::require(detail::is_row_whole(whole), function, "the sum of all weights times steps",
                    "an integer from 1 to 4096", whole);
    return {size, half, steps, whole, 1.0f / (whole * whole), 1.0 / (double(whole) * double(whole))};
}

/// Weights of the texels that a kernel touches along an axis: integers with the sum row.whole.
/// @param row       from make_window_row, or one of windows.hpp
/// @param moved     distance that the kernel has moved, in 1/256 texel, 0 .. 255
/// @param weights   receives row.touched() of them
/// @formula         w_i = floor(K_i r + K_(i-1) s), s = moved, in steps of the row, r = steps - s; the central one gets
///                  the rest. Quadratic: floor((256 - s)^2 / 32), the rest, floor(s^2 / 32)
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

/// Weighted count of the lit texels under a kernel.
///
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called row.touched()^2 times, with indices
///                   up to row.touched() / 2 texels outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param row        from make_window_row
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           0 .. row.whole^2
///
/// @edge             coord outside texel space or NaN: all lit. Receiver beyond the far plane: all lit. NaN receiver:
///                   0. row.size not from 1 to 15: all lit. Other numbers that make_window_row never returns: undefined
/// @formula          sum of w_i w_j [receiver <= fetch(first + (i, j))], w by window_weights; first = texel - size / 2,
///                   where 256 texel + moved = floor(256 coord), minus 128 for an odd size
/// @exactness        A: integers up to 2^24
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window_sum(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row,
                           Compare is_lit = {}) {
    const T whole = static_cast<T>(row.whole);
    if (!in_filter_domain(coord, receiver, is_lit) || !detail::is_row_size(row.size)) return whole * whole;
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

/// Weighted fraction of lit texels under a kernel. Parameters and edge cases as for window_sum.
/// @return        visibility in [0, 1]: 0 in shadow, 1 lit
/// @formula       window_sum / row.whole^2
/// @exactness     A where row.whole is a power of two; else B: the sum is exact, its product with row.scale rounds once
/// @cite          Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row, Compare is_lit = {}) {
    const T sum = window_sum(fetch, coord, receiver, row, is_lit), whole = static_cast<T>(row.whole);
    if (!(sum < whole * whole)) return T(1);  // the product with a rounded scale might miss 1
    if constexpr (std::same_as<T, double>) return sum * row.scale_of_doubles;
    else return sum * row.scale;
}

namespace glsl {
namespace detail {

/// Number of the parameter that holds a kernel's i-th weight.
constexpr int window_parameter(int size, int i) { return i < size - 1 - i ? i : size - 1 - i; }

/// Weight of the i-th touched texel, without the floors.
[[nodiscard]] inline std::string window_weight(int size, int i) {
    const constant ahead{'a', window_parameter(size, i)}, behind{'b', window_parameter(size, i - 1)};
    return filled(i == 0 ? "r * k$a" : (i == size ? "s * k$b" : "r * k$a + s * k$b"), {ahead, behind});
}

[[nodiscard]] inline std::string window_sum_text(int size) {
    const int middle = size / 2;
    const char *const quads[] = {"a", "b", "c", "d"}, *const lanes[] = {"x", "y", "z", "w"};
    std::string text = filled(R"GLSL(
// umbrage_window_sum$n: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k$m    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
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
    // not negative already. The max keeps compilers from regrouping the sum n across it
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
                                    .summary = Size == 3   ? "weighted count of lit texels under a 3x3 kernel"
                                               : Size == 5 ? "weighted count of lit texels under a 5x5 kernel"
                                                           : "weighted count of lit texels under a 7x7 kernel",
                                    .exactness = tier::a,
                                    .needs = list<&in_filter_domain, &lit_2x2>,
                                    .source = {detail::window_sum_text, Size}};

inline constexpr const snippet* window_snippets[]{&window_sum<3>, &window_sum<5>, &window_sum<7>};

}  // namespace glsl
}  // namespace umbrage
