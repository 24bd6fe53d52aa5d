// SPDX-License-Identifier: MIT
//
// Measures by which the examples compare setups.
#include <doctest/doctest.h>

#include <array>
#include <limits>

#include <common/quality.hpp>
#include <common/stability.hpp>

using namespace example;

TEST_CASE("measure_quality: mean, percentile, greatest, skipped and the image, by hand") {
    umbrage::image<float> extents({10, 10});
    const auto report = measure_quality(
        {.screen = {10, 10}, .map_size = {32, 64}, .maps = 3},
        [](glm::ivec2 p) {
            const auto value = static_cast<float>(p.x + 10 * p.y);  // 0: nothing to see
            if (p == glm::ivec2(9)) return glm::mat2(std::numeric_limits<float>::quiet_NaN());
            return glm::mat2(value, 0, 0, value / 2);
        },
        extents.view());
    CHECK(report.measured == 98);
    CHECK(report.skipped == 1);
    CHECK(report.mean == doctest::Approx(49.5));
    CHECK(report.p95 == 93);
    CHECK(report.greatest == 98);
    CHECK(report.storage_factor == doctest::Approx(3 * (32 * 98.0) * (64 * 49.0) / 100));
    CHECK(extents[{0, 0}] == 0);
    CHECK(extents[{3, 2}] == 23);
    CHECK(extents[{9, 9}] == 0);
    const auto nothing =
        measure_quality({.screen = {3, 3}, .map_size = {8, 8}}, [](glm::ivec2) { return glm::mat2(0); });
    CHECK(nothing.measured == 0);
    CHECK(nothing.greatest == 0);
}

TEST_CASE("measure_stability: points that stay, move by whole texels, drift, flicker, leave and pass on, by hand") {
    constexpr placed_point nowhere{};
    const std::array<std::array<placed_point, 3>, 6> by_point{{
        {{{0, {3.25, 4}, 0.5}, {0, {3.25, 4}, 0.5}, {0, {3.25, 4}, 0.5}}},  // stays
        {{{0, {3.25, 4}, 1}, {0, {-96.75, 7}, 1}, {0, {2.25, 4}, 1}}},      // by whole texels
        {{{1, {3.5, 4}, 0}, {1, {9.5, 3.875}, 0}, {1, {3.5, 4}, 0}}},       // an eighth and back
        {{{0, {3.25, 4}, 1}, {1, {1.6, 0.3}, 0}, {0, {5.25, 4}, 1}}},       // by way of another map
        {{{0, {1, 1}, 0.25}, nowhere, {0, {1, 1}, 0.5}}},                   // in another light when back
        {{nowhere, {2, {0.1, 0.2}, 1}, nowhere}},                           // seen once
    }};
    const auto up_to = [&](int frames) {
        return measure_stability(frames, by_point.size(), [&](int frame) {
            return [&, frame](std::size_t i) { return by_point[i][static_cast<std::size_t>(frame)]; };
        });
    };
    const stability_report one = up_to(1), two = up_to(2), three = up_to(3);
    CHECK(one.compared == 0);
    CHECK(one.share() == 0);
    CHECK(two.drift == 0.125);
    CHECK(two.compared == 3);
    CHECK(two.changed == 0);
    CHECK(two.change == 0);
    CHECK(three.drift == 0.125);
    CHECK(three.compared == 5);
    CHECK(three.changed == 1);
    CHECK(three.change == 0.25);
    CHECK(three.share() == 0.2);
}

TEST_CASE("measure_stability: what adds up over frames is seen, though no step of it is") {
    const auto creeping = measure_stability(101, 1, [](int frame) {
        return [frame](std::size_t) { return placed_point{0, {0.0, 0.001953125 * frame}, 1}; };
    });
    CHECK(creeping.drift == 0.1953125);
}
