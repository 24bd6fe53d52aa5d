// SPDX-License-Identifier: MIT
//
// Numbers of filters that their members exclude: functions that take a filter for many lookups refuse them. A filter
// alone gives an answer.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include <umbrage/core/image.hpp>
#include <umbrage/filter/filters.hpp>

#include "../../special_values.hpp"

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
float alone(const auto& filter) {
    const image<float> map = step();
    const glm::vec2 at(19.7f, 20.2f);
    if constexpr (requires { filter.points; }) return filter(bordered(map), at, 0.5f, glm::ivec2(3, 1));
    else return filter(bordered(map), at, 0.5f);
}

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

TEST_CASE_TEMPLATE("check: a softness is what make_penumbra_params makes", Filter, filters::pcss, filters::dpcf) {
    const auto of = [](float x, float low, float high, float y = 0.06f) {
        return Filter{.softness = {x, y, low, high}};
    };
    for (const float per_code : {0.0f, 0.06f, 4096.0f}) {
        CHECK(passes(of(per_code, 16, 96)));
        CHECK(passes(of(0.06f, 16, 96, per_code)));
    }
    for (const float bad : {-0.06f, 4097.0f, 1e30f, nan32, inf32}) {
        CHECK_FALSE(passes(of(bad, 16, 96)));
        CHECK_FALSE(passes(of(0.06f, 16, 96, bad)));
    }
    CHECK(passes(of(0.06f, 0, 0)));
    CHECK(passes(of(0.06f, 4095, 4095)));
    for (const glm::vec2 bad :
         {glm::vec2(96, 16), {-1, 16}, {-5, -3}, {1.5f, 96}, {16, 96.25f}, {16, 4096}, {16, 1e9f}})
        CHECK_FALSE(passes(of(0.06f, bad.x, bad.y)));
    for (const float bad : {nan32, inf32, -inf32}) {
        CHECK_FALSE(passes(of(0.06f, bad, 96)));
        CHECK_FALSE(passes(of(0.06f, 16, bad)));
    }
    CHECK_THROWS_WITH_AS(detail::require_filter("shadow", of(0.06f, 96, 16)),
                         "umbrage::shadow: filter.softness.min_radius and max_radius must be integers in order, from 0 "
                         "to 4095; got (96, 16). They are in 1/16 texel: make_penumbra_params computes them.",
                         std::invalid_argument);
}

TEST_CASE_TEMPLATE("check: alone, any softness gives a visibility", Filter, filters::pcss, filters::dpcf) {
    const float odd[]{nan32, -nan32, inf32, -inf32, 0.0f, -1.0f, 0.06f, 7.25f, 96.0f, 1e9f, -1e30f, 3e38f};
    for (const float per_code : odd)
        for (const float low : odd)
            for (const float high : odd)
                for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
                    const float one = alone(Filter{.softness = {per_code, 0.06f, low, high}, .direction = direction});
                    CHECK(one >= 0.0f);
                    CHECK(one <= 1.0f);
                }
}

TEST_CASE("check: alone, any rotation gives a visibility, that of the first where it is none of sheared_rotation's") {
    const image<float> map = step();
    const glm::vec2 at(19.7f, 20.2f);
    const glm::vec4 soft(0.06f, 0.04f, 16, 96);
    for (const glm::vec4 odd : {glm::vec4(nan32),
                                {inf32, 0, 0, 64},
                                {64, 0, 0, -inf32},
                                {1e30f, 0, 0, 64},
                                {600, 0, 0, 64},
                                {64, 0, nan32, 64}}) {
        CHECK(disc<16>(bordered(map), at, 0.5f, 3.0f, odd) ==
              disc<16>(bordered(map), at, 0.5f, 3.0f, glm::vec4(64, 0, 0, 64)));
        CHECK(pcss<16>(bordered(map), at, 0.5f, soft, odd) ==
              pcss<16>(bordered(map), at, 0.5f, soft, glm::vec4(64, 0, 0, 64)));
        CHECK(dpcf<16>(bordered(map), at, 0.5f, soft, odd) ==
              dpcf<16>(bordered(map), at, 0.5f, soft, glm::vec4(64, 0, 0, 64)));
    }
    // the largest of sheared_rotation counts
    CHECK(disc<16>(bordered(map), at, 0.5f, 3.0f, glm::vec4(576, 0, 0, 64)) !=
          disc<16>(bordered(map), at, 0.5f, 3.0f, glm::vec4(64, 0, 0, 64)));
}

TEST_CASE("check: a window has a row of make_window_row; alone, another size is lit") {
    for (const filters::window& filter : filters::window::values) CHECK(passes(filter));
    CHECK(passes(filters::window{make_window_row(15, {1, 1, 1, 1, 1, 1, 1, 2})}));
    for (const int size : {16, 17, 1000, 0, -1}) {
        filters::window filter;
        filter.row.size = size;
        CHECK_FALSE(passes(filter));
        CHECK(alone(filter) == 1.0f);
    }
    const auto refused = [](const auto& change) {
        filters::window filter;
        change(filter.row);
        return !passes(filter);
    };
    CHECK(refused([](window_row& row) { row.steps = 0; }));
    CHECK(refused([](window_row& row) { row.steps = 512; }));
    CHECK(refused([](window_row& row) { row.whole = nan32; }));
    CHECK(refused([](window_row& row) { row.whole = 2048; }));
    CHECK(refused([](window_row& row) { row.half[0] = nan32; }));
    CHECK(refused([](window_row& row) { row.half[0] = -4; }));
    CHECK(refused([](window_row& row) { row.quadratic = true; }));
    filters::window wide;
    wide.row.size = 16;
    CHECK_THROWS_WITH_AS(detail::require_filter("shadow", wide),
                         "umbrage::shadow: filter.row must be of make_window_row; got 16. That is its size; its "
                         "weights, steps and whole count, too.",
                         std::invalid_argument);
}

TEST_CASE("check: any other callable passes, unless its own check refuses it") {
    struct mine {
        int points = 12;
    };
    struct careful : mine {
        void check(std::string_view function) const { throw std::invalid_argument(std::string(function)); }
    };
    CHECK(passes(mine{}));
    CHECK_THROWS_WITH_AS(detail::require_filter("visibility", careful{}), "visibility", std::invalid_argument);
}
