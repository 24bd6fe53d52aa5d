// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <umbrage/images/moment_table.hpp>

#include "../fusing.hpp"
#include "../special_values.hpp"
#include "last_piece_first.hpp"

using namespace umbrage;

TEST_CASE("make_moment_table: in any pieces; refuses what could wrap, and takes what just cannot") {
    image<float> map({300, 300});
    std::mt19937 random(8);
    for (float& d : map.texels()) d = static_cast<float>(random() % 65536) / 65535.0f;
    map[{0, 0}] = nan32;  // the far plane
    const moment_table of{.radius = 127};
    const auto table = make_moment_table(map.view(), of);
    CHECK(table.size() == glm::ivec2(602, 301));
    const auto pieces = make_moment_table(map.view(), of, last_piece_first{5});
    CHECK(std::equal(table.texels().begin(), table.texels().end(), pieces.texels().begin()));
    CHECK(glm::vec4(table[{1, 1}]) == glm::floor(to_optimized_moments(encode_msm(1.0f)) * 65535.0f + 0.5f));
    CHECK_THROWS_AS((void)make_moment_table(map.view(), {.radius = 128}), std::invalid_argument);  // 257^2 > 65537
    const image<float> strip({65537, 1}, 0.0f), wider({65538, 1}, 0.0f);
    CHECK(make_moment_table(strip.view(), {.radius = 32767}).size().x == 2 * 65538);
    CHECK(make_moment_table(wider.view(), {.radius = 32767}).size().x == 2 * 65539);  // 65535 texels of it
    for (const int radius : {-1, 32768})
        CHECK_THROWS_AS((void)make_moment_table(map.view(), {.radius = radius}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_moment_table(image_view<const float>(), {}), std::invalid_argument);
}

TEST_CASE("visibility from a moment table: the primitive for each receiver") {
    image<float> map({90, 70});
    std::mt19937 random(9);
    for (float& d : map.texels()) d = static_cast<float>(random() % 65536) / 65536.0f;
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const moment_table of{.radius = 9, .direction = direction};
        const auto table = make_moment_table(map.view(), of);
        image<glm::vec3> receivers({80, 60});
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 80; ++x)
                receivers[{x, y}] = {float(x) * 1.3f - 5.0f, float(y) * 1.3f - 5.0f, 0.2f + float(x + y) / 200.0f};
        image<float> out(receivers.size()), at_edge(receivers.size());
        visibility(table.view(), of, receivers.view(), 9, out.view(), last_piece_first{5});
        visibility(table.view(), of, receivers.view(), 9, at_edge.view(), serial{}, outside_map::clamped);
        int wrong = 0, outside = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 80; ++x) {
                const glm::vec3 r = receivers[{x, y}];
                const bool inside = map_covers(glm::vec2(map.size()), glm::vec2(r));
                const float wanted =
                    summed_moments([&](glm::ivec2 t) { return glm::vec4(table[t]); }, table.size(), glm::vec2(r), r.z,
                                   9.0f, of.bias, cleared_depth(direction), outside_map::clamped);
                const float within = may_fuse ? 1.0f / 64 : 0.0f;  // fused, as tier C says
                wrong += std::abs(at_edge[{x, y}] - wanted) > within;
                wrong += std::abs(out[{x, y}] - (inside ? wanted : 1.0f)) > within;
                outside += !inside && wanted < 1.0f;
            }
        CHECK(wrong == 0);
        CHECK(outside > 100);
        const auto with_radius = [&](int radius) {
            visibility(table.view(), of, receivers.view(), radius, out.view());
        };
        CHECK_THROWS_AS(with_radius(10), std::invalid_argument);
        CHECK_THROWS_AS(with_radius(-1), std::invalid_argument);
        image<float> other({80, 61});
        CHECK_THROWS_AS(visibility(table.view(), of, receivers.view(), 1, other.view()), std::invalid_argument);
        CHECK_THROWS_AS(visibility(image_view<const glm::u16vec4>(), of, receivers.view(), 1, out.view()),
                        std::invalid_argument);
    }
}
