// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <umbrage/shadow/cascaded_maps.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("cascaded_maps: uniforms are those of make_cascade_uniforms, moved to the middle of the last map") {
    const auto all = shadow_scene::cascades(unity_clip_space);
    const auto u = cascaded_maps(all).make_uniforms({256, 256}, glm::dvec3(0));
    const auto plain = make_cascade_uniforms(all, 0.0f);
    CHECK(u.rotation == plain.rotation);
    const glm::dvec3 there = glm::dmat3(plain.rotation) * glm::dvec3(u.anchor);
    for (glm::length_t i = 0; i < 3; ++i) {
        CHECK(glm::vec3(u.scales[i]) == glm::vec3(plain.scales[i]));
        const glm::dvec3 offset = glm::dvec3(plain.offsets[i]) + there * glm::dvec3(plain.scales[i]);
        CHECK(glm::length(glm::dvec3(u.offsets[i]) - offset) < 1e-4);
    }
    CHECK(glm::vec2(u.blending) == glm::vec2(1.0f / 16.0f, 2));
    CHECK(glm::length(glm::vec3(u.offsets[2]) - glm::vec3(128, 128, 0.5f)) < 1e-3f);
}

TEST_CASE("cascaded_maps: places are those of the lights' matrices, also where a fit in float has rounded them") {
    auto fit = shadow_scene::range(cpu_clip_space);
    const glm::vec3 away(40000, -30000, 50000);
    fit.map_size = {240, 200};  // where the projection of an integer offset is no float
    fit.camera.position += away, fit.scene.low += away, fit.scene.high += away;
    const auto all = make_stable_cascades<3>(fit, practical_splits<3>(0.5f, 60.0f, 0.9f));
    const cascaded_maps of(all);
    const auto u = of.make_uniforms(fit.map_size, glm::dvec3(0));
    std::array<int, 3> met{};
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 world = away + glm::vec3(float(i % 40) - 20.0f, 0, float(i / 40) - 25.0f);
        const map_place place = cascaded_maps<>::places(u, {.map_size = fit.map_size}, world, shadow_scene::up)[0];
        if (place.at.x == outside_all_maps) continue;
        const auto map = static_cast<std::size_t>(place.number);
        const glm::dvec4 exact = texture_matrix(of.lights()[map], fit.map_size) * glm::dvec4(world, 1);
        CHECK(glm::length(glm::dvec3(place.at) - glm::dvec3(exact)) < 1e-3);
        ++met[map];
    }
    for (const int count : met) CHECK(count > 10);
}

TEST_CASE("cascaded_maps: a shadow of another size than the fit's is refused, in both kinds of up to eight cascades") {
    auto fit = shadow_scene::range(cpu_clip_space);
    const auto refused = [](const auto& cascades, glm::ivec2 size) -> std::string {
        try {
            const shadow sun(cascades, size, filters::tent<3>);
            // of the fit's size: the table darkens what lies below it, and nothing else
            image<float> map(sun.size(), sun.cleared());
            sun.draw(map, shadow_scene::mesh);
            int wrong = 0;
            for (float x = -3; x < 3; x += 0.25f)
                for (float z = -3; z < 3; z += 0.25f) {
                    const float edge = std::fmax(std::abs(x), std::abs(z)) - 1;
                    const glm::vec3 world(x + 0.2f, 0, z + 0.2f);  // 2 units along the light below the table
                    if (std::abs(edge) > 0.2f) wrong += (edge < 0) != (sun(map, world, shadow_scene::up) < 0.5f);
                }
            return wrong == 0 ? "right" : "wrong";
        } catch (const std::invalid_argument& error) { return error.what(); }
    };
    const auto check = [&](const auto& make) {
        const std::string text = "umbrage::shadow: map_size must be cascade_fit.map_size, ";
        fit.map_size = {512, 256};
        CHECK(refused(make(fit), {512, 256}) == "right");
        CHECK(refused(make(fit), {256, 512}) == text + "512 x 256; got 256 x 512");
        fit.map_size = {1024, 1024};
        CHECK(refused(make(fit), {1024, 1024}) == "right");
        CHECK(refused(make(fit), {2048, 2048}) == text + "1024 x 1024; got 2048 x 2048");
        CHECK(refused(make(fit), {512, 512}) == text + "1024 x 1024; got 512 x 512");
    };
    check([](const auto& f) { return make_stable_cascades<3>(f, practical_splits<3>(0.5f, 60.0f, 0.9f)); });
    check([](const auto& f) { return make_tight_cascades<3>(f, practical_splits<3>(0.5f, 60.0f, 0.9f)); });
    check([](const auto& f) { return make_stable_cascades<8>(f, practical_splits<8>(0.5f, 60.0f, 0.9f)); });
}

TEST_CASE("cascaded_maps: cascades relative to an origin keep the size of their maps") {
    const auto exact = make_stable_cascades<1>(
        cascade_fit<double>{.scene = {glm::dvec3(-8), glm::dvec3(8)}, .map_size = {64, 32}, .clip = cpu_clip_space},
        std::array{1.0, 10.0});
    CHECK(exact[0].map_size == glm::ivec2(64, 32));
    CHECK(relative_to(exact, glm::dvec3(5))[0].map_size == glm::ivec2(64, 32));
}

TEST_CASE("cascaded_maps: a scene's width takes no shadow from a table on it") {
    for (const float width : {20.0f, 1e5f, 1e6f, 1e7f}) {
        auto fit = shadow_scene::range(cpu_clip_space);
        fit.scene = {{-width, 0, -width}, {width, 10, width}};
        const shadow sun(make_stable_cascades<4>(fit, practical_splits<4>(0.5f, 60.0f, 0.9f)), fit.map_size,
                         filters::tent<3>);
        image<float> map(sun.size(), sun.cleared());
        sun.draw(map, shadow_scene::mesh);
        const glm::vec3 below(0.2f, 0, 0.2f);  // 2 units along the light below the table
        CHECK(sun(map, below, shadow_scene::up) == 0);
        CHECK(sun(map, {0.2f, 0, 3}, shadow_scene::up) == 1);
        const double range = 1 / std::abs(sun.setup().cascades[0].scale.z);
        CHECK(double(sun.peter_panning_distance(below, shadow_scene::up)) * range < 0.135);
    }
}

TEST_CASE("cascaded_maps: a band that is negative or too narrow for its inverse is refused") {
    const auto all = shadow_scene::cascades(cpu_clip_space);
    for (const float bad : {-1.0f, 1e-45f, std::nanf(""), std::numeric_limits<float>::infinity()})
        CHECK_THROWS_WITH_AS(cascaded_maps(all, bad), doctest::Contains("umbrage::cascaded_maps: blend must be 0, or "),
                             std::invalid_argument);
    for (const float good : {0.0f, 1e-38f, 1e30f})
        CHECK_NOTHROW(shadow(cascaded_maps(all, good), {256, 256}, filters::hard{}));
}
