// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include <umbrage/shadow/adaptive_maps.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("adaptive_maps: a cache that saw nothing yet has the root's page") {
    const auto root = shadow_scene::pages(cpu_clip_space).root;
    const shadow first(adaptive_maps(root, page_cache({.slots = {8, 8}, .deepest_level = 4})), glm::ivec2(136),
                       filters::hard{});
    CHECK(first.setup().lights().size() == 1);
    const image<float> map = shadow_scene::drawn(first);
    CHECK(first(map, {0, 0, 0}, {0, 1, 0}) == 0);
    CHECK(first(map, {5, 0, 5}, {0, 1, 0}) == 1);
}

TEST_CASE("adaptive_maps: all is lit beside the root") {
    const adaptive_maps of = shadow_scene::pages(cpu_clip_space);
    const shadow s(of, {80, 80}, filters::tent<3>);
    const image<float> black(s.size(), 0.0f);
    CHECK(s(black, {0, 0, 0}, {0, 1, 0}) == 0.0f);
    for (const float x : {-30.0f, 30.0f, 1e30f, std::numeric_limits<float>::quiet_NaN()}) {
        CHECK(s(black, {x, 0, 0}, {0, 1, 0}) == 1.0f);
        CHECK(s(black, {0, 0, x}, {0, 1, 0}) == 1.0f);
    }
}

TEST_CASE("adaptive_maps: what a block cannot hold is refused, and what takes it is named") {
    const auto root = shadow_scene::pages(cpu_clip_space).root;
    CHECK_THROWS_WITH_AS(adaptive_maps(root, page_cache({.slots = {9, 2}, .deepest_level = 4})),
                         "umbrage::adaptive_maps: cache.slots must be 8 x 8 or fewer; got 9 x 2. A page table in a "
                         "texture takes more: page_coordinate.",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(adaptive_maps(root, page_cache({.slots = {8, 8}, .deepest_level = 5})),
                         "umbrage::adaptive_maps: cache.deepest_level must be 4 or less; got 5. A page table in a "
                         "texture takes more: page_coordinate.",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(static_cast<void>(shadow_scene::pages(cpu_clip_space).make_uniforms({64, 64}, {})),
                         "umbrage::shadow: map_size must be the pages' pitch(), 80 x 80; got 64 x 64",
                         std::invalid_argument);
}

TEST_CASE("adaptive_maps: a page has a gutter, as wide as the filter reaches, and texels of its own") {
    const auto root = shadow_scene::pages(cpu_clip_space).root;
    const page_cache cache({.slots = {8, 8}, .deepest_level = 4});
    for (const page_size bad : {page_size{128, -4}, {100, 60}, {64, 33}, {0, 0}, {-64, 0}, {96, 4}, {1 << 30, 1 << 29}})
        CHECK_THROWS_AS(adaptive_maps(root, cache, bad), std::invalid_argument);
    const auto made = [&](int gutter, const auto& filter) {
        static_cast<void>(shadow(adaptive_maps(root, cache, {64, gutter}), glm::ivec2(64 + 2 * gutter), filter));
    };
    CHECK_THROWS_WITH_AS(made(8, filters::box{.radius = 8}),
                         "umbrage::shadow: light.size.gutter must be 9 or more; got 8. The filter reaches 8.5 texels "
                         "to each side.",
                         std::invalid_argument);
    CHECK_NOTHROW(made(9, filters::box{.radius = 8}));
    CHECK_THROWS_AS(made(0, filters::hard{}), std::invalid_argument);
    CHECK_NOTHROW(made(1, filters::hard{}));
    CHECK_THROWS_AS(made(0, prefilters::vsm{}), std::invalid_argument);
    CHECK_NOTHROW(made(1, prefilters::vsm{}));
    const filters::pcss soft{.softness = make_penumbra_params(0.3f, 1.0f, 6.0f)};
    CHECK_THROWS_AS(made(5, soft), std::invalid_argument);
    CHECK_NOTHROW(made(6, soft));
}
