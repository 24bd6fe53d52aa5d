// SPDX-License-Identifier: MIT
//
// Numbers of filters that their members exclude: functions that take a filter for many lookups refuse them. A filter
// alone gives an answer.
#include <doctest/doctest.h>

#include <stdexcept>

#include <umbrage/core/image.hpp>
#include <umbrage/filter/check.hpp>

using namespace umbrage;

namespace {

/// True if a filter's numbers pass.
bool passes(const auto& filter) {
    try {
        detail::require_filter("visibility", filter);
    } catch (const std::invalid_argument&) { return false; }
    return true;
}

/// Left half near, right half far.
image<float> step() {
    image<float> map({40, 40});
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) map[{x, y}] = x < 20 ? 0.3f : 0.9f;
    return map;
}
float alone(const auto& filter) { return filter(bordered(step()), glm::vec2(19.7f, 20.2f), 0.5f, glm::ivec2(3, 1)); }

}  // namespace

TEST_CASE_TEMPLATE("check: a disc has 8, 16 or 32 points; alone, any other number is 32", Filter, filters::disc,
                   filters::pcss, filters::dpcf) {
    for (const int points : {8, 16, 32}) CHECK(passes(Filter{.points = points}));
    const float of_32 = alone(Filter{.points = 32});
    for (const int points : {0, -1, 4, 12, 31, 33, 64, 1 << 30}) {
        CHECK_FALSE(passes(Filter{.points = points}));
        CHECK(alone(Filter{.points = points}) == of_32);
    }
    CHECK_THROWS_WITH_AS(detail::require_filter("shadow", Filter{.points = 64}),
                         "umbrage::shadow: filter.points must be 8, 16 or 32; got 64", std::invalid_argument);
}

TEST_CASE("check: any other callable passes") {
    struct mine {
        int points = 12;
    };
    CHECK(passes(mine{}));
}
