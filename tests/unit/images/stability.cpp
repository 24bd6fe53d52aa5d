// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>

#include <umbrage/images/stability.hpp>

#include "../light/clip_spaces.hpp"

using namespace umbrage;

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
    CHECK(complaint([&] { (void)up_to(0); }) == "umbrage::measure_stability: frames must be above 0; got 0");
}

TEST_CASE("measure_stability: what adds up over frames is seen, though no step of it is") {
    const auto creeping = measure_stability(101, 1, [](int frame) {
        return [frame](std::size_t) { return placed_point{0, {0.0, 0.001953125 * frame}, 1}; };
    });
    CHECK(creeping.drift == 0.1953125);
}
