// SPDX-License-Identifier: MIT
//
// That the bias suffices and is the smallest is proof/acne's to say.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>

using namespace umbrage;

TEST_CASE("rasterizer_snap: four times the greatest move of a vertex") {
    CHECK(rasterizer_snap<float> == 4.0f / 512.0f);
    CHECK(rasterizer_snap<double, 4> == 4.0 / 32.0);
}

TEST_CASE_TEMPLATE("acne_free_bias: by hand", T, float, double) {
    using vec = glm::vec<2, T>;
    const T rounding(0x1p-23);
    CHECK(acne_free_bias(vec(0), T(2.5), T(0)) == rounding);
    CHECK(acne_free_bias(vec(T(0.0625), T(-0.125)), T(2), T(0.25)) == T(0.625) + rounding);
    CHECK(acne_free_bias(vec(T(-0.0625), T(0.125)), T(2), T(0.25)) == T(0.625) + rounding);
    CHECK(acne_free_bias(vec(T(0.5)), T(2), T(0)) == 1);
    static_assert(acne_free_bias(vec(T(0.25), T(0)), T(1), T(0)) > T(0.25));
    // 3-4-5: a disc of 2 texels reaches 2 * 0.05 before the plane, and its points' texels 65/128 * 0.07 farther
    CHECK(acne_free_disc_bias(vec(T(0.03), T(-0.04)), T(2), T(0)) == doctest::Approx(0.1 + 0.07 * 65 / 128));
    CHECK(acne_free_disc_bias(vec(0), T(8), T(0.25)) == T(0.25) + rounding);
    CHECK(peter_panning_distance(T(0.25), vec(0), T(2)) == T(0.25) + rounding);  // a caster that faces the light
    CHECK(peter_panning_distance(T(0.25), vec(T(0.0625), T(-0.125)), T(2)) == T(0.625) + rounding);
}

TEST_CASE("acne_free_bias: of filters and encodings, each with the error that counts in its direction") {
    const glm::vec2 slope(0x1p-9f, 0x1p-10f);
    const auto lower = [](depth_direction direction) {
        return rg<11>{.direction = direction, .edge = lower_edge<float>};
    };
    CHECK(acne_free_bias(slope, filters::hard{}, depth32f{}) == 0.5f * 0x1.8p-9f + 0x1p-23f);
    CHECK(acne_free_bias(slope, filters::pcf_2x2{}, depth32f{}) == 0x1.8p-9f + 0x1p-23f);
    CHECK(acne_free_bias(slope, filters::box{.radius = 2}, depth32f{}) == 2.5f * 0x1.8p-9f + 0x1p-23f);
    CHECK(acne_free_bias(glm::vec2(0), filters::hard{}, lower(depth_direction::forward)) == 0x1p-11f + 0x1p-23f);
    CHECK(acne_free_bias(glm::vec2(0), filters::hard{}, lower(depth_direction::reversed)) == 0x1p-23f);
    CHECK(acne_free_bias(glm::vec2(0), filters::hard{}, rg<11>{}) == 0x1p-23f);  // upper edge, forward
}

TEST_CASE_TEMPLATE("acne_free_bias, acne_free_disc_bias: infinite, NaN, zero texels", T, float, double) {
    using vec = glm::vec<2, T>;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (T bad : {inf, -inf, nan, -nan}) {
        for (vec slope : {vec(bad, 0), vec(0, bad), vec(bad)}) {
            CHECK(acne_free_bias(slope, T(1), T(0)) == 1);
            CHECK(acne_free_disc_bias(slope, T(1), T(0)) == 1);
            CHECK(peter_panning_distance(T(0), slope, T(1)) == 1);
        }
        CHECK(acne_free_bias(vec(T(0.1)), T(1), std::abs(bad)) == 1);
        CHECK(acne_free_bias(vec(T(0.1)), std::abs(bad), T(0)) == 1);
        CHECK(acne_free_disc_bias(vec(T(0.1)), std::abs(bad), T(0)) == 1);
    }
    CHECK(acne_free_bias(vec(T(0.1)), T(0), T(0)) == T(0x1p-23));
}

TEST_CASE(
    "peter_panning_distance: a caster before it shadows a biased receiver as an unbiased one, one within it may not") {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> steep(-0x1p-7f, 0x1p-7f), share(0.0f, 1.0f), fraction(0.0f, 1.0f);
    for (const float reach : {0.5f, 1.5f, 2.5f}) {
        const filters::box filter{.radius = static_cast<int>(reach)};
        int lit = 0;
        for (int i = 0; i < 2000; ++i) {
            const glm::vec2 slope(steep(random), steep(random)), caster(steep(random), steep(random));
            const float bias = acne_free_bias(slope, filter, depth32f{}),
                        gap = peter_panning_distance(bias, caster, reach);
            const glm::vec2 coord(20.0f + fraction(random), 20.0f + fraction(random));
            const auto shadowed = [&](float before) {
                const auto fetch = [&](glm::ivec2 texel) {
                    const glm::vec2 way = glm::vec2(texel) + 0.5f - coord;
                    return 0.5f - before + caster.x * way.x + caster.y * way.y;
                };
                return filter(fetch, coord, biased(0.5f, bias)) == 0.0f;
            };
            CHECK(shadowed(gap));
            lit += !shadowed(gap * share(random) * 0.9f);
        }
        CHECK(lit > 500);
    }
}
