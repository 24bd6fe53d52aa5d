// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/look_up.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "../../fusing.hpp"

using namespace umbrage;

namespace {

constexpr float fused = may_fuse ? 1.0f / 64 : 0.0f;  // as tier C says

}  // namespace

TEST_CASE_TEMPLATE("fetch_bilinear: weights by hand, also of the greatest squares", T, float, double) {
    using vec = glm::vec<2, T>;
    const auto fetch = [](glm::ivec2 t) { return T(t.x == 1 ? 4 : 0) + T(t.y == 1 ? 8 : 0); };
    CHECK(fetch_bilinear(fetch, vec(T(0.5))) == 0);
    CHECK(fetch_bilinear(fetch, vec(T(1.5), T(0.5))) == 4);
    CHECK(fetch_bilinear(fetch, vec(T(1), T(0.75))) == 4);
    CHECK(fetch_bilinear(fetch, vec(T(1.5) - T(1.0 / 512), T(1.5))) == T(12) - T(4.0 / 256));
    CHECK(fetch_bilinear(fetch, vec(T(-7.3))) == 0);
    const auto huge = [](glm::ivec2) { return glm::vec<4, T>(T(0x1p110f)); };
    CHECK(fetch_bilinear(huge, vec(T(3.7), T(2.9))) == glm::vec<4, T>(T(0x1p110f)));
}

TEST_CASE("look-ups: decoders of the mean texel; who is not compared is lit") {
    std::mt19937 random(3);
    image<float> depths({16, 16}), warped({16, 16});
    image<glm::vec2> two({16, 16}), evsm_two({16, 16});
    image<glm::vec4> four({16, 16}), evsm_four({16, 16});
    const evsm_parameters p = make_evsm({.exponent = 20.0f});
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const glm::ivec2 at(x, y);
            const float d = depths[at] = static_cast<float>(random() % 1025) / 1024.0f;
            two[at] = encode_vsm(d), warped[at] = encode_esm(d, 20.0f), evsm_two[at] = encode_evsm2(d, 20.0f);
            evsm_four[at] = encode_evsm4(d, p.exponents), four[at] = encode_msm(d);
        }
    const auto turned = [&](glm::ivec2 at) { return to_optimized_moments(fetch_clamped(four.view(), at)); };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 c(static_cast<float>(random() % 4608) / 256.0f - 1.0f,
                          static_cast<float>(random() % 4608) / 256.0f - 1.0f);
        const float r = i % 100 == 0 ? nan : static_cast<float>(random() % 1024) / 1023.0f;
        const auto same = [&](float one, float other) { wrong += !(glm::abs(one - other) <= fused); };
        for (const float far : {1.0f, 0.0f}) {
            same(vsm(clamped(two), c, r, 1e-6f, far), decode_vsm(fetch_bilinear(clamped(two), c), r, 1e-6f, far));
            same(esm(clamped(warped), c, r, 20.0f, far), decode_esm(fetch_bilinear(clamped(warped), c), r, 20.0f, far));
            same(evsm2(clamped(evsm_two), c, r, 20.0f, 1e-3f, far),
                 decode_evsm2(fetch_bilinear(clamped(evsm_two), c), r, 20.0f, 1e-3f, far));
            same(evsm4(clamped(evsm_four), c, r, p.exponents, p.deviations, far),
                 decode_evsm4(fetch_bilinear(clamped(evsm_four), c), r, p.exponents, p.deviations, far));
            const glm::vec4 b = fetch_bilinear(clamped(four), c);
            same(msm(clamped(four), c, r, msm_bias_32, far), decode_msm(b, r, msm_bias_32, far));
            same(msm_hausdorff(clamped(four), c, r, msm_bias_32, far), decode_msm_hausdorff(b, r, msm_bias_32, far));
            same(msm_unorm16(turned, c, r, msm_bias_16, far),
                 decode_msm(from_optimized_moments(fetch_bilinear(turned, c)), r, msm_bias_16, far));
        }
    }
    CHECK(wrong == 0);
    for (const glm::vec2 c : {glm::vec2(nan, 3.0f), glm::vec2(3.0f, 1e9f)})
        CHECK(vsm(clamped(two), c, 1.0f, 0.0f) == 1);
    CHECK(vsm(clamped(two), glm::vec2(3.0f), 1.5f, 0.0f) == 1);         // beyond the far plane
    CHECK(vsm(clamped(two), glm::vec2(3.0f), -0.5f, 0.0f, 0.0f) == 1);  // where depth is reversed
    CHECK(vsm(clamped(two), glm::vec2(3.0f), nan, 0.0f) == 0);
}

TEST_CASE("look-ups: with a border all outside the map is lit, and inside the blur's own edge counts") {
    const float caster = 0.25f, receiver = 0.75f;
    const evsm_parameters p = make_evsm({.exponent = 20.0f});
    const image<glm::vec2> two({4, 4}, encode_vsm(caster)), evsm_two({4, 4}, encode_evsm2(caster, 20.0f));
    const image<float> warped({4, 4}, encode_esm(caster, 20.0f));
    const image<glm::vec4> four({4, 4}, encode_msm(caster)), evsm_four({4, 4}, encode_evsm4(caster, p.exponents)),
        turned({4, 4}, to_optimized_moments(encode_msm(caster)));
    const auto every = [&](glm::vec2 c, const auto& check) {
        const auto both = [&](const auto& map, auto look_up) {
            check(look_up(bordered(map), c), look_up(clamped(map), c));
        };
        both(two, [&](auto fetch, glm::vec2 at) { return vsm(fetch, at, receiver, 1e-6f); });
        both(warped, [&](auto fetch, glm::vec2 at) { return esm(fetch, at, receiver, 20.0f); });
        both(evsm_two, [&](auto fetch, glm::vec2 at) { return evsm2(fetch, at, receiver, 20.0f, 1e-3f); });
        both(evsm_four, [&](auto f, glm::vec2 at) { return evsm4(f, at, receiver, p.exponents, p.deviations); });
        both(four, [&](auto fetch, glm::vec2 at) { return msm(fetch, at, receiver, msm_bias_32); });
        both(four, [&](auto fetch, glm::vec2 at) { return msm_hausdorff(fetch, at, receiver, msm_bias_32); });
        both(turned, [&](auto fetch, glm::vec2 at) { return msm_unorm16(fetch, at, receiver, msm_bias_16); });
    };
    for (const glm::vec2 outside : {glm::vec2(-0.25f, 2), glm::vec2(2, -3), glm::vec2(4, 2), glm::vec2(2, 4.5f)})
        every(outside, [](float lit, float dark) {
            CHECK(lit == 1.0f);
            CHECK(dark < 0.1f);
        });
    for (const glm::vec2 inside : {glm::vec2(0, 0), glm::vec2(0.25f, 3.75f), glm::vec2(2, 2)})
        every(inside, [](float one, float other) { CHECK(glm::abs(one - other) <= fused); });
}
