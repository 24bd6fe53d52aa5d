// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "clip_spaces.hpp"

using namespace umbrage;

namespace {

constexpr glm::ivec2 oblong{640, 480};

spot_light<double> tilted(clip_space clip) {
    return {.position = in_world({3, 8, -2}, clip),
            .direction = in_world({-1, -3, 0.5}, clip),
            .up = in_world({0.1, 1, 0.3}, clip),
            .outer_angle_radians = 0.7,
            .z_near = 0.5,
            .z_far = 40.0,
            .clip = clip};
}

}  // namespace

TEST_CASE("make_spot_light: the same point of the scene, the same texel and depth in every convention") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-20, 20);
    const glm::dmat4 plain = texture_matrix(make_spot_light(tilted(cpu_clip_space)), oblong);
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::dmat4 m = texture_matrix(make_spot_light(tilted(clip)), oblong);
        double worst = 0;
        int tried = 0;
        while (tried < 200) {
            const glm::dvec3 world(coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec4 in_front = plain * glm::dvec4(world, 1);
            if (in_front.w < 0.5) continue;
            ++tried;
            glm::dvec3 expected = glm::dvec3(in_front) / in_front.w;
            if (clip.origin == texture_origin::top) expected.y = oblong.y - expected.y;
            if (clip.direction == depth_direction::reversed) expected.z = 1.0 - expected.z;
            const glm::dvec3 got = through(m, in_world(world, clip));
            worst = worse(worst, glm::length(got - expected) / (1 + glm::length(expected)));
        }
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("make_spot_light: depth runs from the near plane to the far plane, w is the distance") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto light = tilted(clip);
        const glm::dmat4 m = texture_matrix(make_spot_light(light), oblong);
        const glm::dvec3 axis = glm::normalize(light.direction);
        const bool reversed = clip.direction == depth_direction::reversed;
        const glm::dvec3 at_near = through(m, light.position + axis * light.z_near);
        const glm::dvec3 at_far = through(m, light.position + axis * light.z_far);
        CHECK(glm::length(at_near - glm::dvec3(320, 240, reversed ? 1 : 0)) < 1e-10);
        CHECK(glm::length(at_far - glm::dvec3(320, 240, reversed ? 0 : 1)) < 1e-10);
        double before = reversed ? 2 : -2;
        for (double distance = light.z_near; distance < light.z_far; distance *= 1.1) {
            const glm::dvec4 h = m * glm::dvec4(light.position + axis * distance, 1);
            CHECK(h.w == doctest::Approx(distance));
            const double depth = h.z / h.w;
            CHECK((reversed ? depth < before : depth > before));
            before = depth;
        }
    }
}

TEST_CASE("make_spot_light: the cone's edge touches the map's edges and never leaves the map") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto light = tilted(clip);
        const auto space = make_spot_light(light);
        const glm::dmat4 uv = texture_matrix(space, {1, 1});
        const glm::dmat4 back = glm::inverse(space.view);
        const double front = clip.hand == handedness::right ? -1 : 1;
        glm::dvec2 low(2), high(-1);
        for (int i = 0; i < 360; ++i) {
            const double turn = i * std::numbers::pi / 180, extent = std::tan(light.outer_angle_radians);
            const glm::dvec4 edge =
                back * glm::dvec4(extent * std::cos(turn) * 5, extent * std::sin(turn) * 5, 5 * front, 1);
            const glm::dvec2 p(through(uv, glm::dvec3(edge)));
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        CHECK(glm::length(low) < 1e-12);
        CHECK(glm::length(high - 1.0) < 1e-12);
    }
}

TEST_CASE(
    "make_spot_light: a map of any aspect holds the cone, whose edge touches its shorter sides; texels are square") {
    for (clip_space clip : all_clip_spaces())
        for (const glm::ivec2 size : {glm::ivec2(512, 1024), glm::ivec2(1920, 1080), glm::ivec2(64, 64)}) {
            auto light = tilted(clip);
            light.aspect = double(size.x) / size.y;
            const auto space = make_spot_light(light);
            const glm::dmat4 back = glm::inverse(space.view), m = texture_matrix(space, size);
            const double front = clip.hand == handedness::right ? -1 : 1, extent = std::tan(light.outer_angle_radians);
            const double radius = std::min(size.x, size.y) / 2.0;
            for (int i = 0; i < 36; ++i) {
                const double turn = i * std::numbers::pi / 18;
                const glm::dvec3 edge(extent * std::cos(turn) * 5, extent * std::sin(turn) * 5, 5 * front);
                const glm::dvec2 p(through(m, glm::dvec3(back * glm::dvec4(edge, 1))));
                CHECK(glm::length(p - glm::dvec2(size) / 2.0) == doctest::Approx(radius).epsilon(1e-12));
            }
        }
}

TEST_CASE("make_spot_light: straight down and straight up") {
    for (clip_space clip : all_clip_spaces())
        for (float sign : {-1.0f, 1.0f}) {
            const auto light = make_spot_light({.position = {1, 2, 3}, .direction = {0, sign, 0}, .clip = clip});
            const glm::dvec3 p = through(texture_matrix(light, {100, 100}), {1, 2 + 10 * sign, 3});
            CHECK(glm::length(glm::dvec2(p) - 50.0) < 1e-4);
            CHECK((p.z > 0 && p.z < 1));
        }
}

TEST_CASE("make_spot_light: float is double, rounded") {
    for (clip_space clip : all_clip_spaces()) {
        const auto d = tilted(clip);
        const auto f = make_spot_light<float>({.position = d.position,
                                               .direction = d.direction,
                                               .up = d.up,
                                               .outer_angle_radians = 0.7f,
                                               .z_near = 0.5f,
                                               .z_far = 40.0f,
                                               .clip = clip});
        const auto exact = make_spot_light(d);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) {
                CHECK(std::abs(double(f.view[c][r]) - exact.view[c][r]) < 4e-6);
                CHECK(std::abs(double(f.projection[c][r]) - exact.projection[c][r]) < 1e-6);
            }
        CHECK(f.clip == clip);
    }
}

TEST_CASE_TEMPLATE("make_spot_light: bad input", T, float, double) {
    const auto with = [](auto change) {
        spot_light<T> light{.clip = cpu_clip_space};
        change(light);
        (void)make_spot_light(light);
    };
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    CHECK_NOTHROW(with([](auto&) {}));
    const T wider = std::nextafter(T(1.5), T(2));
    for (T angle : {T(0), T(-1), T(-0.0), T(2), wider, std::numbers::pi_v<T> / 2, nan, infinity, -infinity})
        CHECK_THROWS_AS(with([&](auto& l) { l.outer_angle_radians = angle; }), std::invalid_argument);
    for (T aspect : {T(0), T(-1), nan, infinity})
        CHECK_THROWS_AS(with([&](auto& l) { l.aspect = aspect; }), std::invalid_argument);
    CHECK_NOTHROW(with([](auto& l) { l.outer_angle_radians = T(1.5); }));
    CHECK_THROWS_AS(with([](auto& l) { l.direction = {0, 0, 0}; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.direction.y = nan; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.position.z = infinity; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& l) { l.z_near = 0; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& l) { l.z_near = -1; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& l) { l.z_near = l.z_far; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.z_far = -infinity; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.z_near = nan; }), std::invalid_argument);
}

TEST_CASE("make_spot_light: numbers at the ends of float give finite matrices or name the argument") {
    const float greatest = std::numeric_limits<float>::max(), infinity = std::numeric_limits<float>::infinity();
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto with = [&](auto change) {
            spot_light<float> light{.clip = clip};
            change(light);
            return complaint([&] {
                const auto space = make_spot_light(light);
                CHECK(detail::all_finite(space.projection * space.view));
            });
        };
        const bool reversed = clip.direction == depth_direction::reversed;
        CHECK(with([&](auto& l) { l.z_near = 1, l.z_far = greatest; }).empty() == reversed);
        CHECK(with([&](auto& l) { l.z_near = 1, l.z_far = infinity; }).empty());
        CHECK(with([](auto& l) { l.z_near = 1e-30f, l.z_far = 1e-25f; }).empty());
        CHECK(with([](auto& l) {
                  l.outer_angle_radians = 1e-45f;
              }).starts_with("umbrage::make_spot_light: outer_angle_radians "));
        for (const float aspect : {1e-45f, 2e-39f, greatest})
            CHECK(with([&](auto& l) { l.aspect = aspect; }).starts_with("umbrage::make_spot_light: aspect "));
        CHECK(with([](auto& l) {
                  l.position.x = 3e38f;
              }).starts_with("umbrage::make_spot_light: position, outer_angle_radians, z_near and z_far "));
        CHECK(with([](auto& l) {
                  l.position = glm::vec3(3e38f), l.direction = {1, 2, 3};
              }).starts_with("umbrage::make_spot_light: position"));
        CHECK(with([&](auto& l) { l.position.y = infinity; }).starts_with("umbrage::make_spot_light: position "));
        CHECK(with([](auto& l) { l.direction = {}; }).starts_with("umbrage::make_spot_light: direction "));
        CHECK(with([&](auto& l) { l.up.z = -infinity; }).starts_with("umbrage::make_spot_light: up "));
        CHECK(with([](auto& l) { l.z_near = 0; }).starts_with("umbrage::make_spot_light: z_near "));
        CHECK(with([](auto& l) { l.z_near = 1e-45f; }).starts_with("umbrage::make_spot_light: z_near "));
        CHECK(with([](auto& l) { l.z_far = l.z_near; }).starts_with("umbrage::make_spot_light: z_far "));
    }
}

TEST_CASE("make_spot_light: depth between planes of 1e-30 and 1e-25 in binary32, as vertex shaders compute it") {
    for (clip_space clip : all_clip_spaces()) {
        const glm::mat4 m = texture_matrix(
            make_spot_light<float>({.direction = {0, 0, 1}, .z_near = 1e-30f, .z_far = 1e-25f, .clip = clip}),
            {64, 64});
        for (double distance : {1e-30, 1.5e-30, 2e-30, 1e-29, 1e-27, 1e-25}) {
            const double forward = (1 - 1e-30 / distance) / (1 - 1e-5);
            const glm::vec4 h = shadow_coordinate(m, glm::vec3(0, 0, distance));
            CHECK(std::abs(double(project_coordinate(h).z) -
                           (clip.direction == depth_direction::reversed ? 1 - forward : forward)) < 1e-6);
        }
    }
}

TEST_CASE_TEMPLATE("make_spot_light, texture_matrix: whatever the numbers, finite matrices or a named argument", T,
                   float, double) {
    std::mt19937 random(11);
    const int exponents = std::numeric_limits<T>::max_exponent + std::numeric_limits<T>::digits;
    std::uniform_int_distribution<int> exponent(-exponents, std::numeric_limits<T>::max_exponent - 1);
    std::uniform_real_distribution<double> mantissa(1, 2), sign(-1, 1);
    const auto any = [&] { return std::ldexp(T(mantissa(random)), exponent(random)); };
    const auto vector = [&] { return glm::vec<3, T>(any() * T(sign(random)), any() * T(sign(random)), any()); };
    int made = 0, refused = 0, wrong = 0;
    for (int i = 0; i < 40000; ++i) {
        spot_light<T> light{.clip = all_clip_spaces()[std::size_t(i % 16)]};
        if (i & 16) light.position = vector();
        if (i & 32) light.direction = vector();
        if (i & 64) light.up = vector();
        if (i & 128) light.outer_angle_radians = any();
        if (i & 256) light.z_near = any();
        if (i & 512) light.z_far = any();
        if (i & 1024) light.aspect = any();
        const char* called = "umbrage::make_spot_light: ";
        const std::string error = complaint([&] {
            const light_space<T> space = make_spot_light(light);
            wrong += !detail::all_finite(space.view) || !detail::all_finite(space.projection * space.view);
            called = "umbrage::texture_matrix: light and map_size ";
            wrong += !detail::all_finite(texture_matrix(space, {1024, 1024}));
        });
        wrong += !error.empty() && !error.starts_with(called);
        ++(error.empty() ? made : refused);
    }
    CHECK(wrong == 0);
    CHECK(made > 5000);
    CHECK(refused > 5000);
}

TEST_CASE("make_spot_light: a float's tangent is the rounded one, whatever the compiler folds") {
    int wrong = 0;
    for (int i = 1; i < 2000; ++i) {
        const float angle = 1.5f * static_cast<float>(i) / 2000;
        const auto light = make_spot_light<float>({.outer_angle_radians = angle, .clip = opengl_clip_space});
        wrong += light.projection[1][1] != 1 / static_cast<float>(std::tan(static_cast<double>(angle)));
    }
    CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("make_spot_light: a near plane that leaves floats no depth is refused with its limit", T, float,
                   double) {
    const auto refused = [](T z_near, T z_far, clip_space clip) {
        return complaint([&] { (void)make_spot_light<T>({.z_near = z_near, .z_far = z_far, .clip = clip}); });
    };
    clip_space reversed = vulkan_clip_space;
    reversed.direction = depth_direction::reversed;
    const T limit = T(56 * 0x1p-24 * 20);
    for (const clip_space clip : {opengl_clip_space, vulkan_clip_space}) {
        CHECK(refused(limit, T(20), clip).empty());
        CHECK(refused(T(1e-5), T(20), clip) ==
              "umbrage::make_spot_light: z_near must be at least 6.67572e-05 (56 2^-24 z_far) with forward depth; got "
              "1e-05. Take a larger z_near, or reversed depth.");
        CHECK(refused(std::nextafter(limit, T(0)), T(20), clip).starts_with("umbrage::make_spot_light: z_near must "));
        CHECK(refused(T(1e-5), std::numeric_limits<T>::infinity(), clip).empty());
    }
    CHECK(refused(T(1e-5), T(20), reversed).empty());
}
