// SPDX-License-Identifier: MIT
//
// Borders of maps around a point: which of them a filter reads beyond, and how a shadow refuses those.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include <umbrage/filter/filters.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/shadow/shadow.hpp>

namespace shadow_borders {

using namespace umbrage;

/// Maps that are square, each an image of its own: whether a texel lies in one.
[[nodiscard]] inline auto in_square(int side) {
    return [side](glm::vec3, glm::ivec2 texel) {
        return glm::min(texel.x, texel.y) >= 0 && glm::max(texel.x, texel.y) < side;
    };
}

/// Directions from the light in which a filter's visibility depends on texels beyond a map's own.
/// @param is_own   whether a texel belongs to the map that a direction has: bool(glm::vec3, glm::ivec2)
template <class Light, class Filter, class IsOwn>
[[nodiscard]] int reads_beyond(const Light& light, const Filter& filter, const IsOwn& is_own) {
    using setup = typename setup_for<Light>::type;
    const auto uniforms = setup(light).make_uniforms(glm::ivec2(light.map_size), glm::dvec3(0));
    std::mt19937 random(57);
    std::uniform_real_distribution<float> real(-1, 1);
    int count = 0;
    for (int i = 0; i < 20000; ++i) {
        const float x = real(random), y = real(random), z = real(random);
        const glm::vec3 way(x, y, z);
        const map_place place = setup::places(uniforms, {}, way, -way)[0];
        const auto lit_where_own = [&](glm::ivec2 texel) { return is_own(way, texel) ? 1.0f : 0.0f; };
        count += filter(lit_where_own, glm::vec2(place.at), 0.5f) < 1.0f;
    }
    return count;
}

/// Each filter stays in a map whose border is its reach, rounded up, and windows leave any narrower one.
/// @param light   one at the origin
template <class Light, class IsOwn>
void check_need(Light light, const IsOwn& is_own) {
    const auto check = [&](const auto& filter) {
        CAPTURE(filter.name);
        light.border = int(std::ceil(filter.reach()));
        CHECK(reads_beyond(light, filter, is_own) == 0);
        return [&] {
            --light.border;
            return reads_beyond(light, filter, is_own);
        };
    };
    filters::all::for_each(check);
    filters::soft::for_each(check);
    CHECK(check(filters::tent<3>)() > 0);
    CHECK(check(filters::castano<7>)() > 0);
}

/// A shadow refuses a border below the filter's reach by its name, and takes the reach. The default is right for
/// tent<3>.
/// @param light   one with the default border
template <class Light>
void check_refusal(const Light& light) {
    const auto make = [&](int border, const auto& filter) {
        Light changed = light;
        changed.border = border;
        static_cast<void>(shadow(changed, glm::ivec2(light.map_size), filter));
    };
    CHECK_NOTHROW(make(light.border, filters::tent<3>));
    CHECK_THROWS_WITH_AS(
        make(1, filters::tent<3>),
        "umbrage::shadow: light.border must be 2 or more; got 1. The filter reaches 2 texels to each side.",
        std::invalid_argument);
    CHECK_NOTHROW(make(2, filters::tent<3>));
    CHECK_THROWS_WITH_AS(
        make(4, filters::box{.radius = 4}),
        "umbrage::shadow: light.border must be 5 or more; got 4. The filter reaches 4.5 texels to each side.",
        std::invalid_argument);
    CHECK_NOTHROW(make(5, filters::box{.radius = 4}));
    CHECK_THROWS_WITH_AS(
        make(0, filters::hard{}),
        "umbrage::shadow: light.border must be 1 or more; got 0. The filter reaches 0.5 texels to each side.",
        std::invalid_argument);
    CHECK_NOTHROW(make(1, filters::hard{}));
    CHECK_THROWS_AS(make(0, prefilters::vsm{}), std::invalid_argument);
    CHECK_NOTHROW(make(1, prefilters::vsm{}));
    if constexpr (!has_bent_lines<typename setup_for<Light>::type>) {
        const filters::pcss soft{.softness = make_penumbra_params(0.3f, 1.0f, 6.0f)};  // reaches 5.8 texels at most
        CHECK_THROWS_AS(make(5, soft), std::invalid_argument);
        CHECK_NOTHROW(make(6, soft));
    }
}

}  // namespace shadow_borders
