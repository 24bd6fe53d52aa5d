// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shadow/cascade_places.hpp>
#include <umbrage/shadow/frame.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("cascade_places: the next cascade takes over towards a border, without a step") {
    const auto all = shadow_scene::cascades(cpu_clip_space);
    const cascaded_maps of(all, 16.0f);
    const auto u = of.make_uniforms({256, 256}, glm::dvec3(0));
    const shadow_terms terms{.map_size = glm::vec2(256), .reach = 1.0f};
    float before = -1, most = 0;
    int both = 0;
    for (float x = -40; x < 40; x += 0x1p-8f) {
        int looks = 0;
        const float number =
            detail::blended(cascaded_maps<>::places(u, terms, {x, 0, 5}, {0, 1, 0}), [&](const map_place& place) {
                ++looks;
                return float(place.number);
            });
        both += looks == 2;
        if (before >= 0) most = glm::max(most, glm::abs(number - before));
        before = number;
    }
    CHECK(both > 100);
    CHECK(most < 0.07f);  // a step of the weights, or two
}

TEST_CASE("cascade_places: without blending one look-up, also where no cascade holds a point") {
    const cascaded_maps of(shadow_scene::cascades(cpu_clip_space), 0.0f);
    const auto u = of.make_uniforms({256, 256}, glm::dvec3(0));
    const shadow_terms terms{.map_size = glm::vec2(256), .reach = 1.0f};
    for (const float x : {0.0f, 20.0f, 1e6f}) {
        int looks = 0;
        static_cast<void>(
            detail::blended(cascaded_maps<>::places(u, terms, {x, 0, 0}, {0, 1, 0}), [&](const map_place& place) {
                CHECK(place.number >= 0);
                CHECK(place.number <= 2);
                return ++looks, 1.0f;
            }));
        CHECK(looks == 1);
    }
}

TEST_CASE(
    "cascade_places: a next cascade that does not hold a point and its filter has no say, and fades in from there") {
    const cascade_fit<float> fit = shadow_scene::range(cpu_clip_space);
    const auto splits = practical_splits<3>(0.5f, 60.0f, 0.9f);
    const shadow_terms terms{.map_size = glm::vec2(256), .reach = 2.0f};
    for (const auto& all : {make_tight_cascades<3>(fit, splits), make_stable_cascades<3>(fit, splits)}) {
        const auto u = cascaded_maps(all, 16.0f).make_uniforms({256, 256}, glm::dvec3(0));
        int both = 0, beside = 0;
        for (float x = -8; x < 8; x += 0.03f)
            for (float z = -5; z < 15; z += 0.03f) {
                int looks = 0;
                static_cast<void>(
                    detail::blended(cascaded_maps<>::places(u, terms, {x, 0, z}, {0, 1, 0}), [&](const map_place& p) {
                        if (++looks == 2 && p.at.x != outside_all_maps)
                            ++both, beside += !inside_cascade(p.at, terms.map_size, terms.reach);
                        return 1.0f;
                    }));
            }
        CHECK(both > 100);
        CHECK(beside == 0);
    }
}

TEST_CASE("cascade_places: towards the border of the last map the second place lies outside, which is lit") {
    const auto u = cascaded_maps(shadow_scene::cascades(cpu_clip_space)).make_uniforms({256, 256}, glm::dvec3(0));
    const shadow_terms terms{.map_size = glm::vec2(256), .reach = 2.0f};
    bool fades = false, none = false;
    for (float z = 10; z > -400; z -= 0.05f) {
        const auto [own, next] = cascaded_maps<>::places(u, terms, {0.1f, 0.1f * z, z}, {0, 1, 0});  // at one depth
        fades = fades || (own.number == 2 && next.weight > 0.0f && next.at.x == outside_all_maps);
        none = none || (own.at.x == outside_all_maps && next.weight == 0.0f && own.number == 2);
    }
    CHECK(fades);
    CHECK(none);
}
