// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) over the four nearest texels, with bilinear weights: the smallest filter without
// stair-stepped edges. A comparison sampler with linear filtering computes the same in hardware.
//
//     float visibility = umbrage::pcf_2x2(umbrage::bordered(map), coord, depth - bias);
//
// `pcf_2x2` rounds its weights to 1/256, as texture units do, and returns the same bits everywhere.
// `pcf_2x2_dx_sdk` is the DirectX SDK sample's version, with unrounded weights.
// Also called: bilinear PCF, 2x2 PCF, 4-tap PCF. See also: pcf_2x2_hardware.hpp, windows.hpp, disc.hpp.
#pragma once

#include <string_view>
#include <tuple>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

/// Fraction of the light that reaches a receiver: compares it with four stored depths, then blends the four results.
///
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called 4 times, with indices up to one
///                   texel outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit. A multiple of 2^-16
///
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0
/// @formula          sum of w_i [receiver <= fetch(texel_i)], w the bilinear weights in steps of 1/256
/// @exactness        A: sums of multiples of 2^-16, below 2^8
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> x = glm::floor(coord * T(256)) - T(128);  // position between texel centers, in 1/256 texel
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0));
    // Weights of the farther texels are in [0, 1) already. The clamp keeps compilers from regrouping sums across it.
    const glm::vec<2, T> hi = glm::clamp(x * T(1.0 / 256.0) - texel, T(0), T(1));
    const glm::vec<2, T> lo = T(1) - hi;
    const glm::vec<4, T> lit = lit_2x2(fetch, glm::ivec2(texel), receiver, is_lit);
    return lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
}

/// The same filter as in the DirectX SDK ShadowMap sample. Its weights are not rounded. It adds an epsilon to the
/// stored depth, and no bias to the receiver.
///
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called 4 times, with indices up to one
///                   texel outside the map
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel. The sample
///                   puts texel centers at integers, as Direct3D 9 did. This function does not
/// @param receiver   receiver depth in [0, 1], without a bias
/// @param epsilon    depth in [0, 1], added to each stored depth before the comparison
/// @return           visibility in [0, 1]: 0 in shadow, 1 lit
///
/// @edge             coord outside texel space or NaN: 1. Receiver beyond 1: 1
/// @formula          lerp of compare_dx_sdk over x, then y, at coord - 1/2
/// @exactness        B, n = 20: S = (1 + 2 g.x) (1 + 2 g.y), g = coord + 1/2 + floor(coord - 1/2). g is about twice
///                   coord, since a weight is a difference of coordinates
/// @cite             Microsoft DirectX SDK, ShadowMap sample
template <real T, class Fetch>
[[nodiscard]] T pcf_2x2_dx_sdk(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T epsilon) {
    if (!in_filter_domain(coord, receiver)) return T(1);
    const glm::vec<2, T> x = coord - T(0.5);
    const glm::vec<2, T> texel = glm::floor(x);
    const glm::vec<2, T> weight = x - texel;
    const auto lit = [&](int i, int j) {
        return compare_dx_sdk(receiver, T(fetch(glm::ivec2(texel) + glm::ivec2(i, j))), epsilon);
    };
    const T a = lit(0, 0), b = lit(1, 0), c = lit(0, 1), d = lit(1, 1);
    const T low = a + weight.x * (b - a);
    const T high = c + weight.x * (d - c);
    return low + weight.y * (high - low);
}

namespace glsl {

inline constexpr snippet pcf_2x2{
    .name = "pcf_2x2",
    .summary = "bilinear 2x2 PCF, weights in steps of 1/256",
    .exactness = tier::a,
    .needs = list<&in_filter_domain, &lit_2x2>,
    .source = R"GLSL(
// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_pcf_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                    UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 lo = 1.0 - hi;
    UMBRAGE_HIGHP vec4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    UMBRAGE_HIGHP float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
)GLSL",
};

inline constexpr snippet pcf_2x2_dx_sdk{
    .name = "pcf_2x2_dx_sdk",
    .summary = "bilinear 2x2 PCF of the DirectX SDK sample, plain floats",
    .exactness = tier::b,
    .operations = 20,
    .needs = list<&compare_dx_sdk, &in_filter_domain, &fetch_depth>,
    .source = R"GLSL(
// umbrage_pcf_2x2_dx_sdk: 2x2 PCF of the DirectX SDK sample. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], no bias applied
//   epsilon     depth added to each stored depth
UMBRAGE_HIGHP float umbrage_pcf_2x2_dx_sdk(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 weight = x - texel;
    UMBRAGE_HIGHP float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    UMBRAGE_HIGHP float right = umbrage_fetch_depth(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP float above = umbrage_fetch_depth(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP float beyond = umbrage_fetch_depth(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_HIGHP float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    UMBRAGE_HIGHP float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    UMBRAGE_HIGHP float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float low = a + weight.x * (b - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float high = c + weight.x * (d - c);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// Bilinear 2x2 filter as a value.
struct pcf_2x2 {
    static constexpr std::string_view name = "pcf_2x2";
    static constexpr const glsl::snippet* snippet = &glsl::pcf_2x2;

    depth_direction direction = depth_direction::forward;

    static constexpr std::tuple<> numbers(auto&) { return {}; }
    [[nodiscard]] constexpr float reach() const { return 1.0f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2(fetch, coord, receiver, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

/// Filter of the DirectX SDK sample as a value. It compares with compare_dx_sdk.
struct pcf_2x2_dx_sdk {
    static constexpr std::string_view name = "pcf_2x2_dx_sdk";
    static constexpr const glsl::snippet* snippet = &glsl::pcf_2x2_dx_sdk;

    float epsilon = 0.0f;  ///< depth in [0, 1], added to each stored depth
    static constexpr depth_direction direction = depth_direction::forward;  ///< always: the epsilon is added

    static constexpr auto numbers(auto& f) { return std::tie(f.epsilon); }
    [[nodiscard]] constexpr float reach() const { return 1.0f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2_dx_sdk(fetch, coord, receiver, epsilon);
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

}  // namespace filters
}  // namespace umbrage
