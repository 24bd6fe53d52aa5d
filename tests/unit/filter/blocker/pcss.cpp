// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <umbrage/bias/constant.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include "../../rounds.hpp"
#include "../../special_values.hpp"
#include "penumbra_width.hpp"
#include "whole_numbers.hpp"

using namespace umbrage;

namespace {

const glm::vec4 a_turn = disc_rotation(glm::vec2(2, 1));
const glm::vec2 a_receiver(8.3f, 9.1f);

template <int Points>
void check_pcss(bool forward) {
    whole::cases all;
    const comparison is_lit{forward ? depth_direction::forward : depth_direction::reversed};
    int wrong = 0, partly = 0;
    for (int i = 0; i < rounds(4000); ++i) {
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
        wrong +=
            pcss<Points>(clamped(all.map), r.coord, r.depth, light.values(), glm::vec4(r.rotation), is_lit) != share;
        wrong += pcss<Points>(clamped(all.map), glm::dvec2(r.coord), double(r.depth), glm::dvec4(light.values()),
                              glm::dvec4(r.rotation), is_lit) != double(share);
        partly += lit > 0 && lit < Points;
    }
    CHECK(wrong == 0);
    CHECK(partly > rounds(500));
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
    check_widths([](const image<float>& map, glm::vec3 at, glm::vec4 soft, glm::vec4 rotation, comparison is_lit) {
        const float biased = umbrage::biased(at.z, 0x1p-15f, is_lit.direction);
        return pcss<16>(clamped(map), glm::vec2(at), biased, soft, rotation, is_lit);
    });
}

TEST_CASE("pcss: no blocker is lit, all blocked is filtered, and contact is as hard as least says") {
    const glm::vec4 soft(0.25f, 0.25f, 0.0f, 200.0f);
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
    const glm::vec4 point_light(0.0f, 0.0f, 0.0f, 200.0f),
        soft(0.25f, 0.25f, 48.0f, 64.0f);  // a NaN touches: it is on the far plane
    whole::cases all;
    for (int i = 0; i < 500; ++i) {
        const whole::receiver r = all.draw();
        const auto at = [&](glm::ivec2 t) { return static_cast<float>(texel_at(all.map, t.x, t.y)); };
        const float one =
            in_filter_domain(r.coord, r.depth) ? compare(r.depth, at(glm::ivec2(glm::floor(r.coord)))) : 1.0f;
        CHECK(pcss<16>(clamped(all.map), r.coord, r.depth, point_light, glm::vec4(r.rotation)) == one);
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

TEST_CASE("pcss: a straight edge in contact has smaller stair steps than under pcf_2x2") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(0, 1);
    const penumbra_params at_contact{.per_code_x = 0.0f, .per_code_y = 0.0f};
    double by_pcss = 0, by_pcf = 0;
    for (int i = 0; i < rounds(40); ++i) {
        const float angle = 6.2831853f * any(random);
        const glm::vec2 across(std::cos(angle), std::sin(angle)), along(-across.y, across.x);
        const glm::vec2 middle(32 + any(random), 32 + any(random));
        image<float> map({64, 64}, 1.0f);
        for (glm::ivec2 p(0); p.y < 64; ++p.y)
            for (p.x = 0; p.x < 64; ++p.x)
                if (glm::dot(glm::vec2(p) + 0.5f - middle, across) < 0) map[p] = 0.25f;
        // How much visibility varies along the edge, at a distance from it; that of pcss is the mean of its rotations.
        const auto variance = [&](const auto& visibility) {
            double sum = 0, squares = 0;
            const float distance = 2 * any(random) - 1;
            for (int k = -50; k < 50; ++k) {
                const double v = visibility(middle + distance * across + 0.4f * float(k) * along);
                sum += v, squares += v * v;
            }
            return squares / 100 - sum * sum / 1e4;
        };
        by_pcss += variance([&](glm::vec2 coord) {
            double sum = 0;
            for (int r = 0; r < 16; ++r)
                sum += double(filters::pcss{.softness = at_contact}(bordered(map), coord, 0.5f, {r % 4, r / 4}));
            return sum / 16;
        });
        by_pcf += variance([&](glm::vec2 coord) { return double(pcf_2x2(bordered(map), coord, 0.5f)); });
    }
    CHECK(std::sqrt(by_pcss) < 0.8 * std::sqrt(by_pcf));
    CHECK(by_pcf > 0);
}
