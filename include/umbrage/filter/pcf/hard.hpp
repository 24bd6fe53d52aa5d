// SPDX-License-Identifier: MIT
//
// Hard shadow test without a filter: one texel, one comparison.
//
//     float visibility = umbrage::hard(umbrage::bordered(map), coord, depth - bias);
//
// Also called: basic shadow map, hard shadows, nearest-texel test, step(z, depth).
// See also: pcf_2x2.hpp, the smallest filter with smooth edges.
#pragma once

#include <cmath>
#include <string_view>
#include <tuple>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

/// Result of one comparison with the receiver's texel.
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called once
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility: 1 lit, 0 in shadow
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0
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
    .summary = "unfiltered shadow test of the nearest texel",
    .exactness = tier::a,
    .needs = list<&in_filter_domain, &lit>,
    .source = R"GLSL(
// umbrage_hard: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
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

/// Hard shadow test as a value.
struct hard {
    static constexpr std::string_view name = "hard";
    static constexpr const glsl::snippet* snippet = &glsl::hard;

    depth_direction direction = depth_direction::forward;

    static constexpr std::tuple<> numbers(auto&) { return {}; }
    [[nodiscard]] constexpr float reach() const { return 0.5f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::hard(fetch, coord, receiver, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

}  // namespace filters
}  // namespace umbrage
