// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../../special_values.hpp"
#include "whole_numbers.hpp"

using namespace umbrage;

namespace {

const glm::vec2 a_turn = disc_turn(glm::vec2(2, 1)), a_receiver(8.3f, 9.1f);

template <int Points>
void check_pcss(bool forward) {
    whole::cases all;
    const comparison is_lit{forward ? depth_direction::forward : depth_direction::reversed};
    int wrong = 0, partly = 0;
    for (int i = 0; i < 4000; ++i) {
        const whole::receiver r = all.draw();
        const whole::softness light = all.light();
        const std::int64_t z = whole::code(double(r.depth), forward);
        const whole::search found = whole::blockers<Points>(all.map, r, light.radius(z), forward);
        int lit = Points;
        if (found.count > 0) {
            lit = 0;
            whole::for_each_tap<Points>(all.map, r, light.radius(z - found.sum / found.count), [&](double stored) {
                lit += forward ? double(r.depth) <= stored : double(r.depth) >= stored;
            });
        }
        const float share = static_cast<float>(lit) / Points;
        wrong += pcss<Points>(clamped(all.map), r.coord, r.depth, light.values(), glm::vec2(r.turn), is_lit) != share;
        wrong += pcss<Points>(clamped(all.map), glm::dvec2(r.coord), double(r.depth), glm::dvec3(light.values()),
                              glm::dvec2(r.turn), is_lit) != double(share);
        partly += lit > 0 && lit < Points;
    }
    CHECK(wrong == 0);
    CHECK(partly > 500);
}

/// From where a tenth of the light is seen to where nine tenths are, in texels: `seen` at each 1/4 texel.
double penumbra_width(const std::vector<double>& seen) {
    const auto reaches = [&](double share) {
        std::size_t i = 0;
        while (i < seen.size() && seen[i] < share) ++i;
        return static_cast<double>(i);
    };
    return (reaches(0.9) - reaches(0.1)) / 4.0;
}

/// A half plane before a plane, both square to the light's axis: what filter and rays see of the lamp along a line.
void check_width(const light_space<float>& light, double lamp, double blocker, double receiver) {
    constexpr int size = 256, steps = size * 4;
    const glm::mat4 m = texture_matrix(light, {size, size});
    const auto placed = [&](double x, double distance) {
        const auto down = static_cast<float>(-distance);
        return project_coordinate(shadow_coordinate(m, glm::vec3(static_cast<float>(x), 0.0f, down)));
    };
    image<float> map({size, size}, placed(0, receiver).z);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size / 2; ++x) map[{x, y}] = placed(0, blocker).z;
    const bool spot = light.projection[2][3] != 0.0f;
    const double left = double(placed(-1, receiver).x), texels = double(placed(1, receiver).x) - left;  // in 2 units
    const auto soft = make_softness(make_light_units(light, {size, size}), static_cast<float>(lamp), 0.0f, 64.0f);
    const comparison is_lit{light.clip.direction};
    std::vector<double> filtered, traced;
    for (int i = 0; i < steps; ++i) {
        const double x = (i / 4.0 - left) / texels * 2.0 - 1.0;
        const glm::vec3 at = placed(x, receiver);
        double share = 0;
        for (int pixel = 0; pixel < 16; ++pixel) {
            const glm::vec2 turned = disc_turn(glm::vec2(float(pixel % 4), float(pixel / 4)));
            const float biased = is_lit.towards_light(at.z, 0x1p-15f);
            share += double(pcss<16>(clamped(map), glm::vec2(at), biased, glm::vec3(soft), turned, is_lit)) / 16.0;
        }
        filtered.push_back(share);
        int seen = 0;
        constexpr int rays = 200;
        for (int ray = 0; ray < rays; ++ray) {  // to points of the lamp, all around and as many in each ring
            const double r = lamp * std::sqrt((ray + 0.5) / rays), offset = r * std::cos(ray * 2.399963229728653);
            const double to = spot ? offset : x + offset * receiver;  // a sun's are as far away as the near plane's 0
            seen += x + (to - x) * (receiver - blocker) / receiver >= 0;
        }
        traced.push_back(double(seen) / rays);
    }
    const double ours = penumbra_width(filtered), theirs = penumbra_width(traced);
    CAPTURE(ours);
    CAPTURE(theirs);
    CHECK(theirs > 4.0);
    CHECK(std::abs(ours - theirs) <= std::max(1.0, 0.1 * theirs));
}

}  // namespace

TEST_CASE("pcss: search, mean, penumbra and filter in whole numbers, in float and double, forward and reversed") {
    for (const bool forward : {true, false}) {
        check_pcss<8>(forward);
        check_pcss<16>(forward);
        check_pcss<32>(forward);
    }
}

TEST_CASE("pcss: a straight edge's penumbra is as wide as rays to an area light see it") {
    for (const clip_space clip : {opengl_clip_space, clip_space{.direction = depth_direction::reversed}}) {
        for (const float z_far : {12.0f, inf32}) {
            const auto lamp =
                make_spot_light<float>({.direction = {0, 0, -1}, .z_near = 0.5f, .z_far = z_far, .clip = clip});
            for (const double blocker : {1.5, 3.0}) check_width(lamp, 0.3, blocker, 6.0);
        }
        const auto sun = make_directional_light<float>({.direction = {0, 0, -1},
                                                        .offset = 0,
                                                        .map_size = 256,
                                                        .texels_per_unit = 32,
                                                        .z_near = 0,
                                                        .z_far = 12,
                                                        .clip = clip});
        for (const double blocker : {1.0, 4.0}) check_width(sun, 0.05, blocker, 6.0);
    }
}

TEST_CASE("pcss: no blocker is lit, all blocked is filtered, and contact is as hard as least says") {
    const glm::vec3 soft(0.25f, 0.0f, 200.0f);
    const auto nothing = [](glm::ivec2) { return 1.0f; };
    CHECK(pcss<16>(nothing, a_receiver, 0.9f, soft, a_turn) == 1.0f);
    const auto roof = [](glm::ivec2) { return 0.25f; };
    CHECK(pcss<16>(roof, a_receiver, 0.9f, soft, a_turn) == 0.0f);
    // The search sees the roof alone, and so does the filter: what lies beside it is not reached.
    const auto slot = [](glm::ivec2 t) { return t.x < 30 ? 0.25f : 1.0f; };
    CHECK(pcss<16>(slot, a_receiver, 0.26f, soft, a_turn) == 0.0f);
    // On the near plane, and before it: nothing lies between it and the light.
    for (const float at_light : {0.0f, -0.0f, -1.0f, -inf32})
        CHECK(pcss<16>(roof, a_receiver, at_light, soft, a_turn) == 1.0f);
    const auto on_near = [](glm::ivec2) { return 0.0f; };
    CHECK(pcss<16>(on_near, a_receiver, 0.5f, soft, a_turn) == 0.0f);  // mean 0: the widest penumbra
    const auto floor_behind = [](glm::ivec2 t) { return t.x < 8 ? 0.5f : 1.0f; };
    CHECK(pcss<16>(floor_behind, glm::vec2(7.9f, 3.0f), 0.5f + 0x1p-20f, soft, a_turn) == 0.0f);  // touches: least, 0
}

TEST_CASE("pcss: a light of no size, and depths that are none, give finite shares") {
    const glm::vec3 point_light(0.0f, 0.0f, 200.0f),
        soft(0.25f, 48.0f, 64.0f);  // a NaN touches: it is on the far plane
    whole::cases all;
    for (int i = 0; i < 500; ++i) {
        const whole::receiver r = all.draw();
        const auto at = [&](glm::ivec2 t) { return static_cast<float>(texel_at(all.map, t.x, t.y)); };
        const float one = is_compared(r.coord, r.depth) ? compare(r.depth, at(glm::ivec2(glm::floor(r.coord)))) : 1.0f;
        CHECK(pcss<16>(clamped(all.map), r.coord, r.depth, point_light, glm::vec2(r.turn)) == one);
    }
    for (const float odd : {nan32, -nan32, -inf32}) {
        const auto mixed = [odd](glm::ivec2 t) { return t.x % 2 ? odd : 1.0f; };
        const float share = pcss<16>(mixed, a_receiver, 0.9f, soft, a_turn);
        CHECK(share > 0.0f);
        CHECK(share < 1.0f);
        CHECK(pcss<16>(mixed, a_receiver, nan32, soft, a_turn) == 0.0f);
    }
    CHECK(pcss<16>([](glm::ivec2) { return inf32; }, a_receiver, 0.9f, soft, a_turn) == 1.0f);
    for (const glm::vec2 outside : coordinates_outside_texel_space())
        CHECK(pcss<16>([](glm::ivec2) { return 0.0f; }, outside, 0.9f, soft, a_turn) == 1.0f);
    CHECK(pcss<16>([](glm::ivec2) { return 0.0f; }, a_receiver, 1.5f, soft, a_turn) == 1.0f);
    CHECK(pcss<16>([](glm::ivec2) { return 1.0f; }, a_receiver, -0.5f, soft, a_turn, greater_equal{}) == 1.0f);
}

TEST_CASE("filters::pcss: knows itself, and reads no texel beyond its reach") {
    for (const filters::pcss& filter : filters::pcss::values) {
        static_assert(known_filter<filters::pcss>);
        CHECK(filter.snippet->name == filter.name);
        std::mt19937 random(3);
        double farthest = 0;
        for (int i = 0; i < 4000; ++i) {
            const float x = 40.0f + static_cast<float>(random() % 2560) / 256.0f;
            const float y = 40.0f + static_cast<float>(random() % 2560) / 256.0f;
            const auto fetch = [&](glm::ivec2 t) {
                farthest = std::max({farthest, std::abs(t.x + 0.5 - double(x)), std::abs(t.y + 0.5 - double(y))});
                return 0.0f;
            };
            (void)filter(fetch, glm::vec2(x, y), 0.75f, {i % 4, i / 4 % 4});
        }
        CHECK(farthest <= double(filter.reach()) + 1.0 / 256);
        CHECK(farthest > double(filter.reach()) - 0.02);
    }
}
