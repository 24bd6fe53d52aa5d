// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) under a sliding kernel by a comparison sampler. One fetch between two texels
// weights both. It takes 4 fetches for 3 x 3 weights, 9 for 5 x 5 and 16 for 7 x 7.
//
//     constexpr umbrage::window_row row = umbrage::castano_row<5>;
//     float visibility = umbrage::window_hardware(umbrage::bordered(map), coord, depth - bias, row);
//     // in a shader umbrage_window_hardware5(map, size, coord, receiver, 1.0, 3.0, 4.0)
//
// Maps and samplers as for pcf_2x2_hardware.hpp.
// Also called: Castano's PCF, PCF with merged bilinear taps. See also: window.hpp, exact on every GPU.
//
#pragma once

#include <string>

#include <glm/common.hpp>

#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>
#include <umbrage/filter/pcf/window.hpp>

namespace umbrage {

/// Weighted fraction of lit texels under a kernel that slides over the map, with unrounded weights.
///
/// The two texels of a fetch share its weight. An error e of the sampler's fractions moves at most e of that weight
/// from one to the other. The error is e of all weights for one axis, and 2 e for both.
///
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called row.touched()^2 times, with indices
///                   up to row.touched() / 2 texels outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param row        weights above zero; 3, 5 or 7 of them in a shader. row.steps and row.quadratic are ignored
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit
///
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0
/// @formula          sum of w_i w_j [receiver <= fetch(texel + (i, j) - size / 2)] / (sum of the weights)^2,
///                   w_i = K_i + s (K_(i-1) - K_i), texel + s = coord - 1/2 for an odd size, coord for an even
/// @exactness        C, within 1/128: e is 1/256 for a sampler that rounds or truncates to it. Its coordinates
///                   also round, by 2^-10 texel (1e-3) in a map of 8192
/// @cite             Castano: Shadow mapping summary, part 1, 2013
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row,
                                Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> x = coord - T(row.size % 2 ? 0.5 : 0.0), texel = glm::floor(x), s = x - texel;
    const glm::ivec2 first = glm::ivec2(texel) - row.size / 2;
    const auto weight = [&](int i, T moved) {
        const T here(row.weight(i)), before(row.weight(i - 1));
        return here + moved * (before - here);
    };
    T sum(0), whole(0);
    for (int i = 0; i < row.size; ++i) whole += T(row.weight(i));
    for (int j = 0; j <= row.size; ++j)
        for (int i = 0; i <= row.size; ++i)
            sum += weight(i, s.x) * weight(j, s.y) * lit(fetch, first + glm::ivec2(i, j), receiver, is_lit);
    return (glm::min)(sum / (whole * whole), T(1));  // weights round
}

namespace glsl {
namespace detail {

/// A multiple of 1/2 in GLSL.
[[nodiscard]] inline std::string in_halves(double number) {
    const int halves = static_cast<int>(number < 0 ? -number * 2 : number * 2);
    return filled("$s$w.$h", {{'s', 0, number < 0 ? "-" : ""}, {'w', halves / 2}, {'h', halves % 2 * 5}});
}

/// Center of the first texel of a fetch along an axis, in texels from the corner of the receiver's texel.
constexpr double first_center(int size, int k) { return 2 * k - size / 2 + 0.5; }

/// Multiples of a kernel's weights, which are "k0" and so on from its edge, added up in GLSL.
class weighted_sum {
public:
    explicit weighted_sum(int size) : size_(size) {}

    /// Adds a multiple of the weight at an index. There is none outside the kernel.
    weighted_sum& add(double factor, int index) {
        if (index >= 0 && index < size_) factors_[window_parameter(size_, index)] += factor;
        return *this;
    }
    /// @return   the sum; "0.0" if it has no terms
    [[nodiscard]] std::string str() const {
        std::string text;
        for (int i = 0; i < 4; ++i) {
            if (factors_[i] == 0) continue;
            const double factor = factors_[i] < 0 ? -factors_[i] : factors_[i];
            const char* sign = factors_[i] < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
            text += sign;
            append(text, "k$i", {{'i', i}});
            if (factor != 1) text += " * " + in_halves(factor);
        }
        return text.empty() ? "0.0" : text;
    }
    /// @return   the sum as a factor, in brackets if it has several terms
    [[nodiscard]] std::string as_factor() const {
        const std::string sum = str();
        return sum.find(' ') == sum.npos ? sum : '(' + sum + ')';
    }

private:
    int size_;
    double factors_[4]{};
};

/// Lines for the fetch of the texels 2 k and 2 k + 1 along an axis: the weight w of both, the point p between them at
/// which a sampler gives each its share, and v, what of w lies in the map. The weight of texel i is
/// K_i + s (K_(i-1) - K_i). So p is their center of mass, a sum of moments over w.
[[nodiscard]] inline std::string pair_weights(int size, int k) {
    const int one = 2 * k, other = one + 1;
    const double nearer = first_center(size, k), farther = nearer + 1;
    weighted_sum weight(size), change(size), moment(size), moves(size);
    weight.add(1, one).add(1, other);
    change.add(1, one - 1).add(-1, other);
    moment.add(nearer, one).add(farther, other);
    moves.add(nearer, one - 1).add(-nearer, one).add(farther, one).add(-farther, other);
    const std::string both = weight.str(), changes = change.as_factor(), first = moment.str(), then = moves.as_factor();
    return filled(changes == "0.0" ? "    UMBRAGE_HIGHP vec2 w$k = vec2($w, $w);\n"
                                   : "    UMBRAGE_HIGHP vec2 w$k = $w + s * $c;\n",
                  {{'k', k}, {'w', 0, both}, {'c', 0, changes}}) +
           filled(
               "    UMBRAGE_HIGHP vec2 p$k = (texel + ($m + s * $t) / w$k) / size;\n"
               "    UMBRAGE_HIGHP vec2 v$k = w$k * umbrage_covered(size, p$k);\n",
               {{'k', k}, {'m', 0, first}, {'t', 0, then}});
}

[[nodiscard]] inline std::string window_hardware_text(int size) {
    std::string text = filled(R"GLSL(
// umbrage_window_hardware$n: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k$m    weights from the edge to the middle one. The others mirror them
UMBRAGE_HIGHP float umbrage_window_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float k0,
                                             UMBRAGE_HIGHP float k1)GLSL",
                              {{'n', size}, {'m', size / 2}});
    for (int i = 2; i <= size / 2; ++i) append(text, ", UMBRAGE_HIGHP float k$i", {{'i', i}});
    text += R"GLSL() {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_HIGHP vec2 s = x - texel;
    UMBRAGE_HIGHP float whole = k0)GLSL";
    for (int i = 1; i < size; ++i) append(text, " + k$i", {{'i', window_parameter(size, i)}});
    text += ";\n";
    for (int k = 0; 2 * k <= size; ++k) text += pair_weights(size, k);
    text += "    UMBRAGE_HIGHP vec2 inside = v0";
    for (int k = 1; 2 * k <= size; ++k) append(text, " + v$k", {{'k', k}});
    text += ";\n    // ... - s: from the receiver to where the four texels of a fetch meet\n";
    text += "    UMBRAGE_HIGHP float n = 0.0;\n";
    for (int j = 0; 2 * j <= size; ++j) {
        append(text, "    $trow = 0.0;\n", {{'t', 0, j == 0 ? "UMBRAGE_HIGHP float " : ""}});
        for (int i = 0; 2 * i <= size; ++i) {
            const std::string x = in_halves(first_center(size, i)), y = in_halves(first_center(size, j));
            append(
                text,
                "    row += v$i.x * umbrage_lit_between(map, size, vec2(p$i.x, p$j.y), vec2($x, $y) - s, receiver);\n",
                {{'i', i}, {'j', j}, {'x', 0, x}, {'y', 0, y}});
        }
        append(text, "    n += v$j.y * row;\n", {{'j', j}});
    }
    text += R"GLSL(    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    UMBRAGE_HIGHP float share = clamp(n / (whole * whole), 0.0, 1.0);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL";
    return text;
}

}  // namespace detail

template <int Size>
inline constexpr snippet window_hardware{
    .name = Size == 3 ? "window_hardware3" : (Size == 5 ? "window_hardware5" : "window_hardware7"),
    .summary = Size == 3   ? "3x3 kernel, 4 fetches from a linear comparison sampler"
               : Size == 5 ? "5x5 kernel, 9 fetches from a linear comparison sampler"
                           : "7x7 kernel, 16 fetches from a linear comparison sampler",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&in_filter_domain, &within_far_plane, &covered, &lit_between>,
    .source = {detail::window_hardware_text, Size}};

inline constexpr const snippet* window_hardware_snippets[]{&window_hardware<3>, &window_hardware<5>,
                                                           &window_hardware<7>};

}  // namespace glsl
}  // namespace umbrage
