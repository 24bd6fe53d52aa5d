// SPDX-License-Identifier: MIT
//
// Exhibits: what maps of moments hold, and what a blur makes of it.
#include "museum.hpp"

#include <glm/exponential.hpp>
#include <umbrage/filter/prefiltered/evsm.hpp>

#include "half.hpp"

namespace {

using namespace umbrage;
using glm::vec2;
using glm::vec4;

// Variance as published, of any pair of moments.
float chebyshev_bound(vec2 m, float depth, float min_variance) {
    const float variance = std::fmax(m.y - m.x * m.x, min_variance), d = depth - m.x;
    return depth <= m.x ? 1.0f : variance / (variance + d * d);
}

// A shadow of 64 x 64 texels with one broken texel in the middle, under a box blur of 11 x 11: visibility of a receiver
// behind each texel. One texel in 121 counts as lit.
template <class Texel, class Decode>
score beside_a_broken_texel(Texel texel, Decode decode) {
    constexpr int reach = 5, around = 121;
    const auto shadow = texel(0.3f), broken = texel(3.0f);
    score s;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool in_blur = std::abs(x - 32) <= reach && std::abs(y - 32) <= reach;
            const auto mean = in_blur ? (shadow * float(around - 1) + broken) * (1.0f / float(around)) : shadow;
            s.add(double(decode(mean, 0.6f)) - (in_blur ? 1.0 / around : 0.0), 1.0 / 16.0);
        }
    return s;
}
// The exponent is natural, as in the engine.
vec2 unclamped_warp(float depth) {
    const float w = std::exp(15.0f * (2.0f * depth - 1.0f));
    return {w, w * w};
}
float visibility_of_warp(vec2 m, float depth) {
    const float w = unclamped_warp(depth).x, deviation = 0.0025f * 15.0f * w;
    return chebyshev_bound(m, w, deviation * deviation);
}

// Receivers 1/20 behind surfaces at 972 depths, which the map holds as halves: dark.
template <class Decode>
score behind_surfaces(Decode decode) {
    score s;
    for (int k = 0; k < 972; ++k) {
        const float surface = float(k) / 1024.0f;
        s.add(double(decode(surface, surface + 0.05f)), 1.0 / 16.0);
    }
    return s;
}
float as_half(float v) { return float(half(v).v); }

const evsm_parameters single = make_evsm({}),
                      halves = make_evsm({.exponent = 5, .falling = 5, .store = float_store::half});

const exhibit all[] = {
    {"Squares of light flicker inside a shadow",
     "playcanvas/engine#7480, explained and mended in playcanvas/engine#9124",
     "A degenerate triangle has a depth beyond 1. Its power is enormous. The blur spreads it over a square.",
     "w = exp(15 (2 z - 1)), z not clamped", "texels of a shadow around a broken one, visibility more than 1/16 off",
     "visibility", "`encode_evsm4` clamps the depth. Its falling power bounds the light of one texel",
     [] { return beside_a_broken_texel(unclamped_warp, visibility_of_warp); },
     [] {
         return beside_a_broken_texel(
             [](float d) { return encode_evsm4(d, single.exponents); },
             [](vec4 m, float d) { return decode_evsm4(m, d, single.exponents, single.deviations); });
     }},
    {"Far from the light nothing casts a shadow", "milos-agathon/forge3d#145. An exponent of 40 is usual in 32 bits",
     "Powers of depth exceed 65504, the largest half. A mean of infinity lights every receiver.",
     "(w, w^2) in halves, w = exp(40 z)", "receivers 1/20 behind 972 surfaces, visibility above 1/16", "visibility",
     "`make_evsm` takes the store, and refuses exponents whose powers do not fit",
     [] {
         return behind_surfaces([](float surface, float depth) {
             const float m = std::exp(40.0f * surface), w = std::exp(40.0f * depth);
             return chebyshev_bound(vec2(as_half(m), as_half(m * m)), w, 1e-4f * w * w);
         });
     },
     [] {
         return behind_surfaces([](float surface, float depth) {
             const vec4 m = encode_evsm4(surface, halves.exponents);
             return decode_evsm4(vec4(as_half(m.x), as_half(m.y), as_half(m.z), as_half(m.w)), depth, halves.exponents,
                                 halves.deviations);
         });
     }},
};

}  // namespace

std::span<const exhibit> moments() { return all; }
