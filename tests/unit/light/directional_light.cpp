// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "clip_spaces.hpp"

using namespace umbrage;

TEST_CASE("make_directional_light: the exercise's setup on points worked out by hand, in every convention") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto check = [&](const glm::dmat4& m, glm::dvec3 world, glm::dvec3 expected) {
            CAPTURE(world.x);
            CHECK(glm::length(through(m, in_world(world, clip)) - in_convention(expected, clip, 1024)) < 1e-9);
        };
        // 1024 texels at 10 a unit are 102.4 units; the light is 10 units before the target
        const glm::dmat4 along_z =
            texture_matrix(make_directional_light<double>(
                               {.direction = in_world({0, 0, -2}, clip), .z_near = 0.5, .z_far = 20.5, .clip = clip}),
                           {1024, 1024});
        check(along_z, {0, 0, 0}, {512, 512, 9.5 / 20});
        check(along_z, {51.2, 51.2, 9.5}, {1024, 1024, 0});
        check(along_z, {-51.2, -51.2, -10.5}, {0, 0, 1});
        check(along_z, {1, 2, 3}, {522, 532, 6.5 / 20});

        // along (1, -1, 0) with y up: right is +z, above is (1, 1, 0) / sqrt 2
        const double root = std::sqrt(0.5);
        const glm::dmat4 oblique = texture_matrix(make_directional_light<double>({.direction = {1, -1, 0},
                                                                                  .target = in_world({5, 6, 7}, clip),
                                                                                  .offset = 4,
                                                                                  .texels_per_unit = 100,
                                                                                  .z_near = 1,
                                                                                  .z_far = 9,
                                                                                  .clip = clip}),
                                                  {1024, 1024});
        check(oblique, {5, 6, 7}, {512, 512, 3.0 / 8});
        check(oblique, {6, 7, 8}, {612, 512 + 200 * root, 3.0 / 8});
        check(oblique, {6, 5, 7}, {512, 512, (3 + 2 * root) / 8});
        check(oblique, glm::dvec3(5, 6, 7) - 4.0 * root * glm::dvec3(1, -1, 0),
              {512, 512, -1.0 / 8});  // the light itself
    }
}

TEST_CASE("make_directional_light: texels are as dense in maps that are no squares") {
    for (clip_space clip : all_clip_spaces())
        for (const glm::ivec2 size : {glm::ivec2(512, 1024), glm::ivec2(300, 7)}) {
            const glm::dmat4 m =
                texture_matrix(make_directional_light<double>(
                                   {.direction = in_world({0, 0, -2}, clip), .map_size = size, .clip = clip}),
                               size);
            const auto expected = in_convention(glm::dvec3(size.x / 2.0 + 10, size.y / 2.0 + 20, 0), clip, size.y);
            CHECK(glm::length(glm::dvec2(through(m, in_world({1, 2, 0}, clip))) - glm::dvec2(expected)) < 1e-9);
        }
}

TEST_CASE("make_directional_light: the light is at target - direction * offset") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> coordinate(-5, 5);
    for (clip_space clip : all_clip_spaces())
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 direction(coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec3 target(coordinate(random), coordinate(random), coordinate(random));
            const double offset = coordinate(random);
            const auto light = make_directional_light<double>(
                {.direction = direction, .target = target, .offset = offset, .clip = clip});
            const glm::dvec3 position = target - glm::normalize(direction) * offset;
            CHECK(glm::length(through(light.view, position)) < 1e-13);
            CHECK(light.clip == clip);
        }
}

TEST_CASE("make_directional_light: straight down and up, float near double") {
    for (clip_space clip : all_clip_spaces())
        for (float sign : {-1.0f, 1.0f}) {
            const glm::mat4 m = texture_matrix(
                make_directional_light({.direction = {0, sign, 0}, .z_near = 1, .z_far = 19, .clip = clip}),
                {1024, 1024});
            CHECK(glm::length(through(m, {0, 0, 0}) - glm::dvec3(512, 512, 0.5)) < 1e-4);
            CHECK(std::abs(through(m, {0, -9 * sign, 0}).z - (clip.direction == depth_direction::forward ? 0 : 1)) <
                  1e-6);
            const glm::dvec3 moved = through(m, {3, 0, 4});
            CHECK(glm::length(glm::dvec2(moved) - 512.0) == doctest::Approx(50.0));  // 5 units, 10 texels each
        }
}

TEST_CASE_TEMPLATE("make_directional_light: bad input", T, float, double) {
    const auto with = [](auto change) {
        directional_light<T> light{.clip = cpu_clip_space};
        change(light);
        (void)make_directional_light(light);
    };
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    CHECK_NOTHROW(with([](auto&) {}));
    for (int size : {0, -1, std::numeric_limits<int>::min()})
        CHECK_THROWS_AS(with([&](auto& l) { l.map_size.y = size; }), std::invalid_argument);
    for (T density : {T(0), T(-1), nan, infinity})
        CHECK_THROWS_AS(with([&](auto& l) { l.texels_per_unit = density; }), std::invalid_argument);
    for (T bad : {nan, -nan, infinity, -infinity}) {
        CHECK_THROWS_AS(with([&](auto& l) { l.offset = bad; }), std::invalid_argument);
        CHECK_THROWS_AS(with([&](auto& l) { l.direction.x = bad; }), std::invalid_argument);
        CHECK_THROWS_AS(with([&](auto& l) { l.target.x = bad; }), std::invalid_argument);
        CHECK_THROWS_AS(with([&](auto& l) { l.z_near = bad; }), std::invalid_argument);
        CHECK_THROWS_AS(with([&](auto& l) { l.z_far = bad; }), std::invalid_argument);
    }
    CHECK_THROWS_AS(with([](auto& l) { l.direction = {0, 0, 0}; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& l) { l.z_near = l.z_far; }), std::invalid_argument);
    CHECK_NOTHROW(with([](auto& l) { l.z_near = -5; }));
    CHECK_NOTHROW(with([](auto& l) { l.offset = 0; }));
}

TEST_CASE("make_directional_light: numbers at the ends of float give finite matrices or name the argument") {
    const float greatest = std::numeric_limits<float>::max(), infinity = std::numeric_limits<float>::infinity();
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto with = [&](auto change) {
            directional_light<float> light{.clip = clip};
            change(light);
            return complaint([&] {
                const auto space = make_directional_light(light);
                CHECK(detail::all_finite(space.projection * space.view));
            });
        };
        const std::string name = "umbrage::make_directional_light: ";
        CHECK(with([](auto& l) { l.map_size = {0, 8}; }).starts_with(name + "map_size "));
        CHECK(with([&](auto& l) { l.texels_per_unit = infinity; }).starts_with(name + "texels_per_unit "));
        CHECK(with([](auto& l) {
                  l.map_size = {1, 1}, l.texels_per_unit = 3e38f;
              }).starts_with(name + "map_size and texels_per_unit "));
        CHECK(with([](auto& l) { l.texels_per_unit = 1e-45f; }).starts_with(name + "map_size and texels_per_unit "));
        CHECK(with([](auto& l) { l.texels_per_unit = 3e38f; }).empty());  // 1024 texels over half the range
        CHECK(with([](auto& l) {
                  l.texels_per_unit = 3e38f, l.target.x = 1e4f;
              }).starts_with(name + "target, offset, texels_per_unit, z_near and z_far "));
        CHECK(with([](auto& l) { l.z_near = -3e38f, l.z_far = 3e38f; }).starts_with(name + "z_near and z_far "));
        CHECK(with([](auto& l) { l.z_near = l.z_far; }).starts_with(name + "z_near and z_far "));
        CHECK(with([&](auto& l) { l.z_far = infinity; }).starts_with(name + "z_near and z_far "));
        CHECK(with([](auto& l) { l.z_near = 1e-30f, l.z_far = 1e-20f; }).empty());
        CHECK(with([&](auto& l) { l.offset = infinity; }).starts_with(name + "offset "));
        CHECK(with([&](auto& l) { l.offset = greatest, l.z_far = 1; }).starts_with(name + "target, offset, "));
        CHECK(with([&](auto& l) { l.target.y = infinity; }).starts_with(name + "target "));
        CHECK(with([](auto& l) { l.direction = {}; }).starts_with(name + "direction "));
        CHECK(with([&](auto& l) { l.up.x = infinity; }).starts_with(name + "up "));
    }
}

TEST_CASE("make_directional_light: a sun that passes straight above turns its map, unless up is across its path") {
    /// Cosine of the angle by which a map turns over a thousandth of a radian, at the zenith.
    const auto turn = [](glm::dvec3 up) {
        const auto x_axis = [&](double angle) {
            const auto light = make_directional_light<double>(
                {.direction = {std::sin(angle), -std::cos(angle), 0}, .up = up, .clip = cpu_clip_space});
            return glm::dvec3(light.view[0][0], light.view[1][0], light.view[2][0]);
        };
        return glm::dot(x_axis(-1e-3), x_axis(0));
    };
    CHECK(turn({0, 0, 1}) > 0.999);
    CHECK(std::abs(turn({0, 1, 0})) < 0.01);
}
