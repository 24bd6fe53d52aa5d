// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <random>
#include <stdexcept>

#include <umbrage/images/variance_table.hpp>

#include "../special_values.hpp"
#include "last_piece_first.hpp"

using namespace umbrage;

namespace {

image<float> evenly_random_depths(glm::ivec2 size, float low, float high) {
    std::mt19937 random(5);
    image<float> map(size);
    for (float& d : map.texels()) d = low + (high - low) * static_cast<float>(random() % 65536) / 65536.0f;
    return map;
}

}  // namespace

TEST_CASE("make_variance_table: sums of codes and squares before each column and row, modulo 2^32, in any pieces") {
    const image<float> map = evenly_random_depths({150, 140}, -0.1f, 1.2f);
    const variance_table of{.bits = 11, .radius = 16};
    const auto table = make_variance_table(map.view(), of),
               pieces = make_variance_table(map.view(), of, last_piece_first{5});
    REQUIRE(table.size() == map.size() + 1);
    image<glm::uvec2> wanted(table.size(), glm::uvec2(0));
    for (int y = 1; y <= map.size().y; ++y) {
        glm::uvec2 row(0);
        for (int x = 1; x <= map.size().x; ++x) {
            const float d = map[{x - 1, y - 1}];
            const std::uint32_t code = d < 0 ? 0 : (d >= 1 ? 2047 : static_cast<std::uint32_t>(d * 2048.0f));
            row += glm::uvec2(code, code * code);
            wanted[{x, y}] = wanted[{x, y - 1}] + row;
        }
    }
    int wrong = 0;
    for (int y = 0; y < table.size().y; ++y)
        for (int x = 0; x < table.size().x; ++x) {
            const glm::u16vec4 t = table[{x, y}];
            wrong += glm::uvec2(t.x + 65536u * t.y, t.z + 65536u * t.w) != wanted[{x, y}] || pieces[{x, y}] != t;
        }
    CHECK(wrong == 0);
    CHECK(wanted[map.size()].x > 20000000);
}

TEST_CASE("make_variance_table: refuses what could wrap, and takes what just cannot") {
    image<float> map({64, 64}, 0.0f);
    const auto made = [&](int bits, int radius) {
        return make_variance_table(map.view(), {.bits = bits, .radius = radius}).size() == glm::ivec2(65);
    };
    // Codes of one value: 24 bits of the sum are the limit, of the part of the box that the map has.
    CHECK(made(12, 31));
    CHECK(made(12, 1000));
    image<float> wide({65, 64}, 0.0f);
    CHECK_THROWS_AS((void)make_variance_table(wide.view(), {.bits = 12, .radius = 32}), std::invalid_argument);
    // 33 x 33 texels: 1089 (s^2 / 4 + 1) < 2^32 up to a spread of 3971 codes.
    map[{3, 3}] = 3971.0f / 4096.0f;
    CHECK(made(12, 16));
    map[{3, 3}] = 3972.0f / 4096.0f;
    CHECK_THROWS_AS((void)made(12, 16), std::invalid_argument);
    CHECK(made(11, 16));
    map[{3, 3}] = nan32;  // the far plane
    CHECK(made(11, 16));
    CHECK_THROWS_AS((void)made(12, 16), std::invalid_argument);
    for (const int bits : {0, 13}) CHECK_THROWS_AS((void)made(bits, 1), std::invalid_argument);
    for (const int radius : {-1, 32768}) CHECK_THROWS_AS((void)made(8, radius), std::invalid_argument);
    CHECK_THROWS_AS((void)make_variance_table(image_view<const float>(), {}), std::invalid_argument);
}

TEST_CASE("make_variance_table: the widest spread that it takes comes back whole") {
    image<float> map({33, 33}, 0.0f);
    for (int i = 0; i < 33 * 33 / 2; ++i) map.texels()[static_cast<std::size_t>(i)] = 3971.0f / 4096.0f;
    const auto table = make_variance_table(map.view(), {.bits = 12, .radius = 16});
    const glm::vec4 m = box_moments<float>([&](glm::ivec2 t) { return glm::vec4(table[t]); }, {0, 0}, {33, 33});
    const std::int64_t low = 544, sum = low * 3971, mean = sum / 1089;
    const std::int64_t squares = low * (3971 - mean) * (3971 - mean) + (1089 - low) * mean * mean;
    CHECK(squares < std::int64_t(1) << 32);
    CHECK(squares > std::int64_t(1) << 31);
    CHECK(m == glm::vec4(glm::dvec4(double(mean), double(sum % 1089), double(squares >> 12), double(squares & 4095))));
}

TEST_CASE("visibility from a variance table: the primitive for each receiver") {
    const image<float> map = evenly_random_depths({90, 70}, 0.2f, 0.8f);
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const variance_table of{.bits = 10, .radius = 9, .direction = direction};
        const comparison is_lit{direction};
        const auto table = make_variance_table(map.view(), of);
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
                const float wanted = summed_variance([&](glm::ivec2 t) { return glm::vec4(table[t]); }, map.size(),
                                                     glm::vec2(r), r.z, 9.0f, 1024.0f, is_lit, outside_map::clamped);
                wrong += at_edge[{x, y}] != wanted;
                wrong += out[{x, y}] != (inside ? wanted : 1.0f);
                outside += !inside && wanted < 1.0f;
            }
        CHECK(wrong == 0);
        CHECK(outside > 100);
        const auto with_radius = [&](int radius) {
            visibility(table.view(), of, receivers.view(), radius, out.view());
        };
        CHECK_THROWS_AS(with_radius(10), std::invalid_argument);
        CHECK_THROWS_AS(with_radius(-1), std::invalid_argument);
        for (const int bits : {-1, 0, 13, 40})
            CHECK_THROWS_AS(visibility(table.view(), {.bits = bits, .radius = 9}, receivers.view(), 1, out.view()),
                            std::invalid_argument);
        image<float> other({80, 61});
        CHECK_THROWS_AS(visibility(table.view(), of, receivers.view(), 1, other.view()), std::invalid_argument);
        CHECK_THROWS_AS(visibility(image_view<const glm::u16vec4>(), of, receivers.view(), 1, out.view()),
                        std::invalid_argument);
    }
}
