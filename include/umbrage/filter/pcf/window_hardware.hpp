// SPDX-License-Identifier: MIT
//
// Windows by the sampler: a look-up between two texels weighs both, and where it lies says how much of either. So a
// window of 3 x 3 weights takes 4 look-ups, one of 5 x 5 takes 9, one of 7 x 7 takes 16.
//
//     constexpr umbrage::window_row row = umbrage::castano_row<5>;
//     float visibility = umbrage::window_hardware(umbrage::clamped(map), coord, depth - bias, row);
//     // in a shader umbrage_window_hardware5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0)
//
// Maps and samplers are as for pcf_2x2_hardware.hpp.
//
#pragma once

#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>
#include <umbrage/filter/pcf/window.hpp>

namespace umbrage {

/// What the sampler gives, but for the rounding of its weights: window.
///
/// The two texels of a look-up divide between them what it weighs. A sampler whose fractions are off by up to e moves
/// no more than e of that from one to the other: of all weights of an axis e, of both axes 2 e.
///
/// @param row     of 3, 5 or 7 weights above zero, times its steps whole numbers: then window floors nothing
/// @return        visibility, 0 in shadow, 1 lit
/// @exactness     C, within 1/128 in a shader: e is 1/256 of a sampler that rounds or truncates to it; on top its
///                coordinates round, by 2^-10 texel in a map of 8192
/// @cite          Castano: Shadow mapping summary, part 1, 2013
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row,
                                Compare is_lit = {}) {
    return window(fetch, coord, receiver, row, is_lit);
}

namespace glsl {
namespace detail {

/// For each look-up along an axis: what the farther of its texels weighs, what both do, and where it lies.
constexpr long_text window_hardware_text(int size) {
    long_text text =
        window_head("window_hardware",
                    "lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit", size,
                    R"GLSL(    UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_HIGHP vec2 s = floor((x - texel) * steps);
)GLSL");
    for (int k = 0; 2 * k <= size; ++k) {
        const int texel = 2 * k - size / 2;
        text.append(R"GLSL(    UMBRAGE_HIGHP vec2 b$k = $b;
    UMBRAGE_HIGHP vec2 w$k = $a + b$k;
    UMBRAGE_HIGHP vec2 p$k = (texel $s $t.5 + b$k / w$k) / size;
)GLSL",
                    {{'k', k},
                     {'a', 0, window_weight(size, 2 * k).view()},
                     {'b', 0, window_weight(size, 2 * k + 1).view()},
                     {'s', 0, texel < 0 ? "-" : "+"},
                     {'t', texel < 0 ? -texel - 1 : texel}});
    }
    text.append("    UMBRAGE_HIGHP float n = 0.0;\n");
    for (int j = 0; 2 * j <= size; ++j) {
        text.append("    $trow = 0.0;\n", {{'t', 0, j == 0 ? "UMBRAGE_HIGHP float " : ""}});
        for (int i = 0; 2 * i <= size; ++i)
            text.append("    row += w$i.x * umbrage_lit_at(map, size, vec2(p$i.x, p$j.y), receiver);\n",
                        {{'i', i}, {'j', j}});
        text.append("    n += w$j.y * row;\n", {{'j', j}});
    }
    text.append(R"GLSL(    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return compared ? n * number / (whole * whole) : 1.0;
}
)GLSL");
    return text;
}

}  // namespace detail

template <int Size>
inline constexpr auto window_hardware_text = detail::window_hardware_text(Size);
template <int Size>
inline constexpr snippet window_hardware{
    .name = Size == 3 ? "window_hardware3" : (Size == 5 ? "window_hardware5" : "window_hardware7"),
    .summary = Size == 3   ? "window of 3 x 3 by 4 look-ups of a comparison sampler with a linear filter"
               : Size == 5 ? "window of 5 x 5 by 9 of them"
                           : "window of 7 x 7 by 16 of them",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&is_compared, &lit_at>,
    .source = window_hardware_text<Size>.view()};

inline constexpr auto window_hardware_snippets = list<&window_hardware<3>, &window_hardware<5>, &window_hardware<7>>;

}  // namespace glsl
}  // namespace umbrage
