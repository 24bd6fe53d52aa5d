// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../../special_values.hpp"
#include "whole_numbers.hpp"

using namespace umbrage;

namespace {

constexpr glm::ivec2 light_map_size(512, 512);

/// z of what lies that far down the light's axis, from 0 at the near plane on.
double depth_at(const light_space<float>& light, double distance) {
    const glm::mat4 m = texture_matrix(light, light_map_size);
    const glm::vec3 at = project_coordinate(shadow_coordinate(m, glm::vec3(0, 0, -static_cast<float>(distance))));
    return light.clip.direction == depth_direction::forward ? double(at.z) : 1.0 - double(at.z);
}

template <int Points>
void check_search(bool forward) {
    whole::cases all;
    const comparison is_lit{forward ? depth_direction::forward : depth_direction::reversed};
    int wrong = 0, some = 0;
    for (int i = 0; i < 4000; ++i) {
        const whole::receiver r = all.draw();
        const auto draw = [&] { return static_cast<std::int64_t>(all.random() % (i % 4 ? 96 : 4096)); };
        const std::int64_t wide = draw(), high = i % 2 ? wide : draw();
        const whole::search wanted = whole::blockers<Points>(all.map, r, {wide, high}, forward);
        const glm::vec2 found = blockers<Points>(clamped(all.map), glm::floor(r.coord * 256.0f), r.depth,
                                                 glm::vec2(float(wide), float(high)), glm::vec4(r.rotation), is_lit);
        wrong += found != glm::vec2(static_cast<float>(wanted.count), static_cast<float>(wanted.sum));
        some += wanted.count > 0 && wanted.count < Points;
    }
    CHECK(wrong == 0);
    CHECK(some > 1000);
}

}  // namespace

TEST_CASE("distance_code: 16 bits from the near plane on in either direction, and what no depth is") {
    const greater_equal reversed;
    for (const float code : {0.0f, 1.0f, 4711.0f, 65535.0f}) {
        CHECK(distance_code(code * 0x1p-16f) == code);
        CHECK(distance_code(std::nextafter((code + 1) * 0x1p-16f, 0.0f)) == code);
        CHECK(distance_code(double(code) * 0x1p-16) == double(code));
        CHECK(distance_code(code * 0x1p-16f, reversed) == 65535.0f - code);
    }
    for (const float far : {1.0f, 2.0f, inf32, nan32, -nan32}) CHECK(distance_code(far) == 65535.0f);
    for (const float near : {-1.0f, -0.0f, -inf32, 1e-40f}) CHECK(distance_code(near) == 0.0f);
    for (const float far : {0.0f, -1.0f, -inf32, nan32}) CHECK(distance_code(far, reversed) == 65535.0f);
    for (const float near : {1.0f, 2.0f, inf32})
        CHECK(distance_code(near, comparison{depth_direction::reversed}) == 0.0f);
}

TEST_CASE("penumbra: whole numbers, from min_radius to max_radius") {
    whole::cases all;
    for (int i = 0; i < 5000; ++i) {
        const whole::softness light = all.light();
        const auto apart = static_cast<std::int64_t>(all.random() % 131071) - 65535;
        const whole::ellipse wanted = light.radius(apart);
        CHECK(penumbra(static_cast<float>(apart), light.values()) == glm::vec2(float(wanted.x), float(wanted.y)));
    }
    CHECK(penumbra(65535.0f, glm::vec4(0.0f, 0.0f, 3.0f, 4095.0f)) == glm::vec2(3.0f));  // a light of no size
}

TEST_CASE("blocker, blockers: counts and sums of codes by brute force, NaN a blocker on the far plane") {
    for (const bool forward : {true, false}) {
        check_search<8>(forward);
        check_search<16>(forward);
        check_search<32>(forward);
    }
    const auto fetch = [](glm::ivec2 t) { return t.x == 0 ? nan32 : (t.x == 1 ? 0.25f : 1.0f); };
    CHECK(blocker(fetch, {0, 0}, 0.5f) == glm::vec2(1.0f, 65535.0f));
    CHECK(blocker(fetch, {1, 0}, 0.5f) == glm::vec2(1.0f, 16384.0f));
    CHECK(blocker(fetch, {1, 0}, 0.25f) == glm::vec2(0.0f, 0.0f));
    CHECK(blocker(fetch, {2, 0}, 0.5f) == glm::vec2(0.0f, 0.0f));
    CHECK(blocker(fetch, {2, 0}, nan32) == glm::vec2(1.0f, 65535.0f));
}

TEST_CASE("make_penumbra_params: similar triangles, for spots and directional lights of every convention") {
    // Maps of three shapes: as wide as high, narrower, wider. `texels` are those of light_map_size.
    const auto check = [](const light_space<float>& light, double size, double blocker, double receiver,
                          double texels) {
        const double apart = 65536.0 * (depth_at(light, receiver) - depth_at(light, blocker));
        for (const glm::ivec2 map_size : {light_map_size, glm::ivec2(300, 512), glm::ivec2(512, 96)}) {
            const penumbra_params soft = make_penumbra_params(light, map_size, static_cast<float>(size));
            const glm::dvec2 exact = texels * glm::dvec2(map_size) / glm::dvec2(light_map_size);
            CHECK(std::abs(apart * double(soft.per_code_x) / 16.0 / exact.x - 1.0) < 1.0 / 256 + 1e-4);
            CHECK(std::abs(apart * double(soft.per_code_y) / 16.0 / exact.y - 1.0) < 1.0 / 256 + 1e-4);
            for (const float per_code : {soft.per_code_x, soft.per_code_y}) {
                int exponent = 0;
                const float digits = std::frexp(per_code, &exponent) * 256.0f;
                CHECK(digits == std::floor(digits));
            }
        }
    };
    for (const clip_space clip :
         {opengl_clip_space, vulkan_clip_space,
          clip_space{.range = depth_range::zero_to_one, .direction = depth_direction::reversed},
          clip_space{.range = depth_range::minus_one_to_one, .direction = depth_direction::reversed}}) {
        for (const float z_far : {20.0f, inf32}) {
            spot_light<float> lamp{.direction = {0, 0, -1}, .z_near = 0.5f, .z_far = z_far, .clip = clip};
            const double edge = 2.0 * std::tan(double(lamp.outer_angle_radians)) / light_map_size.x;  // at distance 1
            for (const double blocker : {1.0, 2.5})
                for (const double receiver : {4.0, 9.0})
                    check(make_spot_light(lamp), 0.1, blocker, receiver,
                          0.1 * (receiver - blocker) / blocker / (edge * receiver));
        }
        const auto sun = make_directional_light<float>({.direction = {0, 0, -1},
                                                        .offset = 0,
                                                        .map_size = light_map_size,
                                                        .texels_per_unit = 32,
                                                        .z_near = 0,
                                                        .z_far = 20,
                                                        .clip = clip});
        check(sun, 0.05, 2.0, 7.0, 0.05 * 5.0 * 32.0);
    }
}

TEST_CASE("make_penumbra_params: lights of no size, of any size, and what it refuses") {
    // A texel is 1/16 wide, and 4 units are all depths.
    const auto sun = make_directional_light<float>({.direction = {0, 0, -1},
                                                    .offset = 0,
                                                    .map_size = {64, 64},
                                                    .texels_per_unit = 16,
                                                    .z_near = 0,
                                                    .z_far = 4,
                                                    .clip = cpu_clip_space});
    const glm::ivec2 size(64, 64);
    const auto per_code = [&](const penumbra_params& p) { return glm::vec2(p.per_code_x, p.per_code_y); };
    CHECK(per_code(make_penumbra_params(sun, size, 0.0f)) == glm::vec2(0));
    CHECK(per_code(make_penumbra_params(sun, size, 1e-30f)) == glm::vec2(0));
    CHECK(per_code(make_penumbra_params(sun, size, 1e30f)) == glm::vec2(4096));
    CHECK(per_code(make_penumbra_params(sun, size, 2.0f)) == glm::vec2(1.0f / 32));
    CHECK(per_code(make_penumbra_params(sun, {64, 256}, 2.0f)) == glm::vec2(1.0f / 32, 1.0f / 8));
    const penumbra_params soft = make_penumbra_params(sun, size, 0.1f, 0.5f, 7.03f);
    CHECK(soft.min_radius == 8.0f);
    CHECK(soft.max_radius == 112.0f);
    CHECK(glm::vec4(soft) == glm::vec4(soft.per_code_x, soft.per_code_y, 8.0f, 112.0f));
    for (const float bad : {-1.0f, inf32, nan32})
        CHECK_THROWS_AS((void)make_penumbra_params(sun, size, bad), std::invalid_argument);
    CHECK_THROWS_AS((void)make_penumbra_params(sun, {0, 64}, 0.1f), std::invalid_argument);
    CHECK_THROWS_AS((void)make_penumbra_params(light_space<float>{}, size, 0.1f), std::invalid_argument);
    for (const float bad : {-1.0f, 17.0f, nan32})
        CHECK_THROWS_AS((void)make_penumbra_params(sun, size, 0.1f, bad, 16.0f), std::invalid_argument);
    CHECK_THROWS_AS((void)make_penumbra_params(sun, size, 0.1f, 1.0f, 256.0f), std::invalid_argument);
}
