// SPDX-License-Identifier: MIT
//
// Properties that every filter states, compared with its behavior.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string_view>

#include <umbrage/filter/filters.hpp>

#include "../special_values.hpp"

using namespace umbrage;

namespace {

/// The filter for a direction, where it can take one.
template <class Filter>
bool turn(Filter& filter, depth_direction direction) {
    if constexpr (requires { filter.direction = direction; }) {
        filter.direction = direction;
        return true;
    }
    return direction == depth_direction::forward;
}

template <class Filter, class Coord>
concept takes = requires(const Filter& filter, float (*fetch)(glm::ivec2), Coord coord) {
    filter(fetch, coord, 0.5f);
};

}  // namespace

TEST_CASE("filters: take two coordinates; GLM would cut more down to two without a warning") {
    for_each_filter([]<class Filter>(const Filter&) {
        static_assert(takes<Filter, glm::vec2> && takes<Filter, const glm::vec2&>);
        static_assert(!takes<Filter, glm::vec3> && !takes<Filter, glm::vec4> && !takes<Filter, const glm::vec3&>);
        static_assert(!takes<Filter, glm::dvec3> && !takes<Filter, glm::dvec4>);
    });
    static_assert(!takes<filters::pcss, glm::vec3> && !takes<filters::dpcf, glm::vec4>);
}

TEST_CASE("filters: each knows itself, under a name of its own") {
    std::set<std::string_view> names;
    for_each_filter([&]<class Filter>(const Filter& filter) {
        static_assert(known_filter<Filter>);
        CHECK(names.insert(filter.name).second);
        bool found = false;
        CHECK(with_filter(filter.name, [&]<class Found>(const Found& other) {
            found = std::is_same_v<Found, Filter> && other.name == filter.name && other.snippet == filter.snippet;
        }));
        CHECK(found);
    });
    CHECK(names.contains("pcf_2x2"));
    CHECK_FALSE(with_filter("pcf", [](const auto&) { FAIL("there is none of that name"); }));
}

TEST_CASE("filters: each is named as its snippet, whatever its number of points") {
    for_each_filter([](const auto& filter) { CHECK(filter.name == filter.snippet->name); });
    filters::soft::for_each([](const auto& filter) { CHECK(filter.name == filter.snippet->name); });
    CHECK(filters::disc{.points = 8}.name == "disc8");
    CHECK(filters::pcss{.points = 32}.name == "pcss32");
    CHECK(filters::dpcf{.points = 8}.snippet == &glsl::dpcf<8>);
}

TEST_CASE("filters: no texel lies farther from a receiver than reach, and one comes near it") {
    for_each_filter([](const auto& filter) {
        CAPTURE(filter.name);
        std::mt19937 random(3);
        std::uniform_real_distribution<float> anywhere(20.0f, 90.0f);
        double farthest = 0;
        for (int i = 0; i < 20000; ++i) {
            const glm::vec2 coord(anywhere(random), anywhere(random));
            const auto fetch = [&](glm::ivec2 texel) {
                for (int axis = 0; axis < 2; ++axis)
                    farthest = std::max(farthest, std::abs(double(texel[axis]) + 0.5 - double(coord[axis])));
                return 1.0f;
            };
            if constexpr (requires { filter(fetch, coord, 0.5f, glm::ivec2()); })
                CHECK(filter(fetch, coord, 0.5f, glm::ivec2(i % 4, i / 4 % 4)) == 1.0f);
            else CHECK(filter(fetch, coord, 0.5f) == 1.0f);
        }
        CHECK(farthest <= double(filter.reach()) + 1.0 / 256);  // weights are in steps of 1/256
        CHECK(farthest > double(filter.reach()) - 0.02);
    });
}

TEST_CASE("filters: beyond the far plane all is lit, NaN is in shadow, and coordinates outside texel space are lit") {
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        for_each_filter([direction](auto filter) {
            CAPTURE(filter.name);
            if (!turn(filter, direction)) return;
            const bool forward = direction == depth_direction::forward;
            const auto nearest = [=](glm::ivec2) { return forward ? 0.0f : 1.0f; };  // shadows all it can
            const glm::vec2 coord(5.3f, 7.9f);
            CHECK(filter(nearest, coord, 0.5f) == 0.0f);
            CHECK(filter(nearest, coord, cleared_depth(direction)) == 0.0f);  // on the far plane, not beyond
            for (const float beyond : {1.125f, std::nextafter(1.0f, 2.0f), inf32})
                CHECK(filter(nearest, coord, forward ? beyond : 1.0f - beyond) == 1.0f);
            if (filter.name != "pcf_2x2_dx_sdk") CHECK(filter(nearest, coord, nan32) == 0.0f);
            for (const float outside : {40000.0f, -inf32, nan32})
                CHECK(filter(nearest, glm::vec2(1.0f, outside), 0.5f) == 1.0f);
        });
}
