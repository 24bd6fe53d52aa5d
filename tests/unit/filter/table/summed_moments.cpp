// SPDX-License-Identifier: MIT
//
// Boxes of a table against sums over their texels in wide integers, and visibility against four moments in double.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <umbrage/images/moment_table.hpp>

#include "../../special_values.hpp"
#include "../maps.hpp"

using namespace umbrage;

namespace {

image<float> two_layers(glm::ivec2 size) {
    std::mt19937 random(3);
    image<float> map(size);
    for (float& d : map.texels()) d = (random() % 3 ? 0.25f : 0.7f) + static_cast<float>(random() % 1024) / 16384.0f;
    return map;
}

auto texels_of(const image<glm::u16vec4>& table) {
    return [&table](glm::ivec2 t) { return glm::vec4(table[t]); };
}

}  // namespace

TEST_CASE("box_mean: whole numbers in wide integers, of tables that have wrapped") {
    std::mt19937 random(4);
    const glm::ivec2 size(301, 280);
    image<glm::u16vec4> table({2 * (size.x + 1), size.y + 1}, glm::u16vec4(0));
    image<glm::u64vec4> sums(size + 1, glm::u64vec4(0));
    for (int y = 0; y < size.y; ++y) {
        glm::u64vec4 row(0);
        for (int x = 0; x < size.x; ++x) {
            const std::uint64_t a = 65000 + random() % 536, b = random() % 65536, c = random() % 2 * 65535,
                                d = random() % 9;
            row += glm::u64vec4(a, b, c, d);
            const glm::u64vec4 sum = sums[{x + 1, y + 1}] = sums[{x + 1, y}] + row;
            table[{x + 1, y + 1}] = glm::u16vec4(sum % std::uint64_t(65536));
            table[{size.x + x + 2, y + 1}] = glm::u16vec4(sum / std::uint64_t(65536) % std::uint64_t(65536));
        }
    }
    CHECK(sums[size].x > std::uint64_t(1) << 32);
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        glm::ivec2 first, end;
        for (int axis = 0; axis < 2; ++axis) {
            first[axis] = static_cast<int>(random() % static_cast<unsigned>(size[axis]));
            end[axis] = first[axis] + 1 + static_cast<int>(random() % 255) % (size[axis] - first[axis]);
        }
        const glm::u64vec4 sum = (sums[end] - sums[{first.x, end.y}]) - (sums[{end.x, first.y}] - sums[first]);
        const auto n = static_cast<float>((end.x - first.x) * (end.y - first.y));
        wrong += box_mean<float>(texels_of(table), size.x + 1, first, end) != glm::vec4(sum) / n;
    }
    CHECK(wrong == 0);
}

TEST_CASE("summed_moments: decode_msm of the box's mean, and no darker than its lit share") {
    const image<float> map = two_layers({120, 90});
    std::mt19937 random(6);
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const float far = cleared_depth(direction);
        const moment_table of{.radius = 16, .direction = direction};
        const auto table = make_moment_table(map.view(), of);
        double worst = 0, darker = 0;
        int partly = 0;
        for (int i = 0; i < 1000; ++i) {
            const glm::vec2 coord(static_cast<float>(random() % 1500) / 10.0f - 15.0f,
                                  static_cast<float>(random() % 1200) / 10.0f - 15.0f);
            const int radius = static_cast<int>(random() % 17);
            const float receiver = static_cast<float>(random() % 4097) / 4096.0f;
            const float seen = summed_moments(texels_of(table), table.size(), coord, receiver,
                                              static_cast<float>(radius), of.bias, far, umbrage::outside_map::clamped);
            const glm::ivec2 middle = glm::clamp(glm::ivec2(glm::floor(coord)), glm::ivec2(0), map.size() - 1);
            const glm::ivec2 first = glm::max(middle - radius, glm::ivec2(0));
            const glm::ivec2 end = glm::min(middle + radius + 1, map.size());
            glm::dvec4 mean(0);
            double lit = 0;
            const double n = (end.x - first.x) * (end.y - first.y);
            for (int y = first.y; y < end.y; ++y)
                for (int x = first.x; x < end.x; ++x) {
                    mean += encode_msm(double(map[{x, y}]), double(far)) / n;
                    lit +=
                        (direction == depth_direction::forward ? receiver <= map[{x, y}] : receiver >= map[{x, y}]) / n;
                }
            const double wanted = decode_msm(mean, double(receiver), glm::dvec2(of.bias), double(far));
            worst = std::max(worst, std::abs(wanted - double(seen)));
            darker = std::max(darker, lit - double(seen));
            partly += seen > 0.01f && seen < 0.99f;
        }
        CHECK(worst < 0.057);  // decode_msm
        CHECK(darker < 6e-5 + 0.057);
        CHECK(partly > 200);
        MESSAGE("off by ", worst, " of 0.057; darker than the lit share by ", darker);
    }
}

TEST_CASE("summed_moments: by hand, and what is out of range") {
    image<float> map({3, 1}, 0.25f);
    map[{2, 0}] = 0.75f;
    const auto table = make_moment_table(map.view(), {.radius = 1});
    const auto seen = [&](float x, float receiver) {
        return summed_moments(texels_of(table), table.size(), glm::vec2(x, 0.5f), receiver, 1.0f, msm_bias_16);
    };
    CHECK(seen(0.5f, 0.2f) > 0.99f);
    CHECK(seen(0.5f, 0.5f) < 0.01f);                          // both texels at 1/4
    CHECK(std::abs(seen(1.5f, 0.6f) - 1.0f / 3.0f) < 0.01f);  // a third sees it, two do not
    CHECK(seen(-300.0f, 0.2f) > 0.99f);                       // the nearest box
    for (const float beyond : {1.01f, inf32}) CHECK(seen(1.5f, beyond) == 1.0f);
    CHECK(seen(1.5f, nan32) == 0.0f);
    CHECK(seen(1.5f, -inf32) == 1.0f);
    for (const glm::vec2 outside : coordinates_outside_texel_space())
        CHECK(summed_moments(texels_of(table), table.size(), outside, 0.9f, 1.0f, msm_bias_16) == 1.0f);
    const auto of = [&](float radius) {
        return summed_moments(texels_of(table), table.size(), glm::vec2(1.5f, 0.5f), 0.6f, radius, msm_bias_16);
    };
    for (const float none : {-0.5f, -1.0f, -1e30f, -inf32, nan32, -nan32}) CHECK(of(none) == of(0.0f));
    for (const float all : {32767.0f, 1e30f, inf32}) CHECK(of(all) == of(3.0f));
}
