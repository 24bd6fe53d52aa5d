// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/pcf/disc.hpp>

#include "../../special_values.hpp"
#include "whole_numbers.hpp"

using namespace umbrage;

namespace {

template <int Points>
void check_hardened() {
    for (int ratio = 0; ratio <= 256; ++ratio)
        for (int k = 0; k <= Points; ++k) {
            const double x = double(k) / Points, s = 2 * x < 1 ? -1 : 1, q = ratio / 256.0;
            const double hard = 0.5 + s / 2 * (1 - std::pow(1 - std::abs(2 * x - 1), 3));
            const float ours = hardened_kernel<Points>(static_cast<float>(k), static_cast<float>(ratio));
            CHECK(std::abs(double(ours) - (hard * (1 - q) + x * q)) < 1e-12);
            if (k > 0) CHECK(ours >= hardened_kernel<Points>(static_cast<float>(k - 1), static_cast<float>(ratio)));
            CHECK(hardened_kernel<Points>(double(k), double(ratio)) == double(ours));
        }
    CHECK(hardened_kernel<Points>(0.0f, 0.0f) == 0.0f);
    CHECK(hardened_kernel<Points>(Points / 2.0f, 0.0f) == 0.5f);
    CHECK(hardened_kernel<Points>(float(Points), 0.0f) == 1.0f);
}

template <int Points>
void check_dpcf(bool forward) {
    whole::cases all;
    const comparison is_lit{forward ? depth_direction::forward : depth_direction::reversed};
    constexpr std::int64_t n = Points;
    int wrong = 0, partly = 0;
    for (int i = 0; i < 4000; ++i) {
        const whole::receiver r = all.draw();
        const whole::softness light = all.light();
        const std::int64_t z = whole::code(double(r.depth), forward);
        const whole::ellipse widest = light.radius(z);
        const whole::search found = whole::blockers<Points>(all.map, r, widest, forward);
        const std::int64_t k = found.count, mean = k ? found.sum / k : 0;
        const whole::ellipse own = light.radius(z - mean);
        const std::int64_t whole_width = widest.x + widest.y, q = whole_width ? 256 * (own.x + own.y) / whole_width : 0;
        const std::int64_t u = 2 * k - n, d = n - std::abs(u), steep = n * n * n - d * d * d;
        const std::int64_t dark = (n * n * n + (u < 0 ? -steep : steep)) * (256 - q) + 2 * n * n * k * q;
        const double share = 1.0 - double(dark) / double(512 * n * n * n);
        wrong += double(dpcf<Points>(clamped(all.map), r.coord, r.depth, light.values(), glm::vec4(r.rotation),
                                     is_lit)) != share;
        wrong += dpcf<Points>(clamped(all.map), glm::dvec2(r.coord), double(r.depth), glm::dvec4(light.values()),
                              glm::dvec4(r.rotation), is_lit) != share;
        partly += k > 0 && k < n;
    }
    CHECK(wrong == 0);
    CHECK(partly > 500);
}

}  // namespace

TEST_CASE("hardened_kernel: the cited kernel for every count and ratio, monotone, 0, 1/2 and 1 where they were") {
    check_hardened<8>();
    check_hardened<16>();
    check_hardened<32>();
}

TEST_CASE("dpcf: search, mean, ratio and kernel in whole numbers, in float and double, forward and reversed") {
    for (const bool forward : {true, false}) {
        check_dpcf<8>(forward);
        check_dpcf<16>(forward);
        check_dpcf<32>(forward);
    }
}

TEST_CASE("dpcf: a disc's share where the penumbra is the disc, and the cases without one") {
    const glm::vec4 rotation = disc_rotation(glm::vec2(1, 3));
    const glm::vec2 middle(8.3f, 9.1f);
    const glm::vec4 soft(0.25f, 0.25f, 0.0f, 64.0f), always_widest(0.25f, 0.25f, 64.0f, 64.0f);
    whole::cases all;
    for (int i = 0; i < 500; ++i) {
        const whole::receiver r = all.draw();
        const glm::vec4 turned(r.rotation);
        CHECK(dpcf<16>(clamped(all.map), r.coord, r.depth, always_widest, turned) ==
              disc<16>(clamped(all.map), r.coord, r.depth, 4.0f, turned));
    }
    CHECK(dpcf<16>([](glm::ivec2) { return 1.0f; }, middle, 0.9f, soft, rotation) == 1.0f);
    CHECK(dpcf<16>([](glm::ivec2) { return 0.25f; }, middle, 0.9f, soft, rotation) == 0.0f);
    CHECK(dpcf<16>([](glm::ivec2) { return 0.25f; }, middle, 0.0f, soft, rotation) == 1.0f);
    CHECK(dpcf<16>([](glm::ivec2) { return 0.0f; }, middle, 0.5f, soft, rotation) == 0.0f);
    CHECK(dpcf<16>([](glm::ivec2) { return 0.25f; }, middle, 0.9f, glm::vec4(0.0f), rotation) == 0.0f);
    CHECK(dpcf<16>([](glm::ivec2) { return 0.25f; }, middle, nan32, soft, rotation) == 0.0f);
    CHECK(dpcf<16>([](glm::ivec2) { return nan32; }, middle, 0.5f, soft, rotation) == 0.0f);
    CHECK(dpcf<16>([](glm::ivec2) { return 0.25f; }, middle, 1.5f, soft, rotation) == 1.0f);
    for (const glm::vec2 outside : coordinates_outside_texel_space())
        CHECK(dpcf<16>([](glm::ivec2) { return 0.0f; }, outside, 0.9f, soft, rotation) == 1.0f);
    for (const filters::dpcf& filter : filters::dpcf::values) {
        static_assert(known_filter<filters::dpcf>);
        CHECK(filter.snippet->name == filter.name);
        CHECK(filter.reach() == filters::disc{filter.points, 6.0f}.reach());
    }
}
