// SPDX-License-Identifier: MIT
//
// The unfiltered shadow test: one texel, one comparison.
//
//     float visibility = umbrage::hard(umbrage::bordered(map), coord, depth - bias);
//
#pragma once

#include <cmath>
#include <string_view>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

/// @param fetch      ivec2 texel -> stored depth; called once
/// @param coord      receiver in texels, the first texel's center is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return           1 lit, 0 in shadow
/// @formula          [receiver <= fetch(floor(coord))]
/// @exactness        A
/// @cite             Williams: Casting curved shadows on curved surfaces, SIGGRAPH 1978
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T hard(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    return lit(fetch, glm::ivec2(glm::floor(coord)), receiver, is_lit);
}

namespace glsl {

inline constexpr snippet hard{
    .name = "hard",
    .summary = "nearest texel, one test",
    .exactness = tier::a,
    .needs = list<&in_filter_domain, &lit>,
    .source = R"GLSL(
// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_hard(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 texel = compared ? floor(coord) : vec2(0.0, 0.0);  // no branch: fetches of several taps overlap
    UMBRAGE_HIGHP float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// The filter as a value.
struct hard {
    static constexpr std::string_view name = "hard";
    static constexpr const glsl::snippet* snippet = &glsl::hard;

    comparison is_lit{};

    [[nodiscard]] constexpr float reach() const { return 0.5f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::hard(fetch, coord, receiver, is_lit);
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

}  // namespace filters
}  // namespace umbrage
