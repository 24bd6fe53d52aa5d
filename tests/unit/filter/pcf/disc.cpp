// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <vector>

#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/hard.hpp>

#include "../maps.hpp"

using namespace umbrage;

namespace {

constexpr double pi = std::numbers::pi;

std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// The texel of a point, in integers.
std::int64_t tap_along(double coord, std::int64_t turned, std::int64_t radius) {
    const auto position = static_cast<std::int64_t>(std::floor(coord * 256));
    return floor_divide(position + floor_divide(turned * radius, 64), 256);
}

/// Share of a disc of radius 1 beyond a line at that distance from its middle.
double beyond_line(double distance) {
    return (std::acos(distance) - distance * std::sqrt(1 - distance * distance)) / pi;
}

/// Root mean square, over lines of all directions and distances, of what points say of the disc's share beyond them.
double error_on_edges(const std::vector<glm::dvec2>& points) {
    double sum = 0;
    constexpr int directions = 180, distances = 400;
    for (int a = 0; a < directions; ++a)
        for (int d = 0; d < distances; ++d) {
            const double angle = 2 * pi * (a + 0.5) / directions, distance = 2 * (d + 0.5) / distances - 1;
            double share = 0;
            for (const glm::dvec2 p : points) share += std::cos(angle) * p.x + std::sin(angle) * p.y > distance;
            const double error = share / double(points.size()) - beyond_line(distance);
            sum += error * error;
        }
    return std::sqrt(sum / (directions * distances));
}

template <int Points>
std::vector<glm::dvec2> ours() {
    std::vector<glm::dvec2> points;
    for (const glm::ivec2 p : disc_points<Points>) points.emplace_back(glm::dvec2(p) / 16.0);
    return points;
}

/// Vogel's spiral, as shaders have it in floats.
std::vector<glm::dvec2> vogel(int count) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
        const double r = std::sqrt((i + 0.5) / count), angle = i * 2.399963229728653;
        points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return points;
}

/// Darts thrown at the disc, none within 0.8 of the greatest distance that as many could keep.
std::vector<glm::dvec2> poisson(std::mt19937& random, int count) {
    std::uniform_real_distribution<double> anywhere(-1, 1);
    const double apart = 0.8 * std::sqrt(2 * pi / (std::sqrt(3.0) * count));
    std::vector<glm::dvec2> points;
    for (int misses = 0; static_cast<int>(points.size()) < count; ++misses) {
        if (misses == 2000) points.clear(), misses = 0;
        const glm::dvec2 p(anywhere(random), anywhere(random));
        bool good = p.x * p.x + p.y * p.y <= 1;
        for (const glm::dvec2 q : points) good = good && std::hypot(p.x - q.x, p.y - q.y) >= apart;
        if (good) points.push_back(p);
    }
    return points;
}

template <int Points>
void check_against_whole_numbers() {
    std::mt19937 random(Points);
    const image<float> map = random_map(random, {13, 9});
    const auto xs = awkward_coordinates(random, 13), ys = awkward_coordinates(random, 9);
    int wrong = 0, partly = 0;
    for (std::size_t i = 0; i < 20000; ++i) {
        const glm::vec2 coord(xs[i * 7 % xs.size()], ys[i * 5 % ys.size()]);
        const float receiver = static_cast<float>(i % 9) / 8.0f;
        const auto sixteenths = static_cast<int>(i % 5 == 0 ? random() % 4096 : random() % 80);
        const int v = static_cast<int>(i % 16);
        // cos and sin of 22.5 degrees times v mod 4, in 64ths to the nearest, but 59, 24 rounded down to stay within 64
        constexpr int base[4][2]{{64, 0}, {59, 24}, {45, 45}, {24, 59}};
        int c = base[v % 4][0], s = base[v % 4][1];
        for (int quarter = 0; quarter < v / 4; ++quarter) c = -std::exchange(s, c);
        int lit = 0;
        for (const glm::ivec2 p : disc_points<Points>) {
            const std::int64_t x = tap_along(double(coord.x), c * p.x - s * p.y, sixteenths);
            const std::int64_t y = tap_along(double(coord.y), s * p.x + c * p.y, sixteenths);
            lit += receiver <= static_cast<float>(texel_at(map, x, y));
        }
        const glm::vec4 rotation = disc_rotation(glm::vec2(float(v / 4), float(v % 4)));
        wrong += rotation != glm::vec4(float(c), float(-s), float(s), float(c));
        const float radius = static_cast<float>(sixteenths) / 16.0f;
        const float share = static_cast<float>(lit) / Points;
        wrong += disc<Points>(clamped(map), coord, receiver, radius, rotation) != share;
        wrong += disc<Points>(clamped(map), glm::dvec2(coord), double(receiver), double(radius),
                              glm::dvec4(rotation)) != double(share);
        partly += lit > 0 && lit < Points;
    }
    CHECK(wrong == 0);
    CHECK(partly > 5000);
}

}  // namespace

TEST_CASE("disc: brute force in whole numbers, every rotation, radii up to the greatest, in float and double") {
    check_against_whole_numbers<8>();
    check_against_whole_numbers<16>();
    check_against_whole_numbers<32>();
}

TEST_CASE("disc: no radius is one texel, all lit is 1, and receivers out of range") {
    std::mt19937 random(2);
    const image<float> map = random_map(random, {9, 9});
    const glm::vec4 rotation = disc_rotation(glm::vec2(1, 2));
    for (int i = 0; i < 500; ++i) {
        const glm::vec2 c = glm::vec2(random() % 2304, random() % 2304) / 256.0f;
        const float z = static_cast<float>(i % 9) / 8.0f;
        CHECK(disc<16>(clamped(map), c, z, 0.0f, rotation) == hard(clamped(map), c, z));
        CHECK(disc<32>(clamped(map), c, -1.0f, 9.0f, rotation) == 1.0f);
        CHECK(disc<8>(clamped(map), c, std::numeric_limits<float>::quiet_NaN(), 2.0f, rotation) == 0.0f);
        CHECK(disc<8>(clamped(map), c, 1.5f, 2.0f, rotation) == 1.0f);
        CHECK(disc<8>(clamped(map), c, -0.5f, 2.0f, rotation, greater_equal{}) == 1.0f);
    }
    for (glm::vec2 outside : coordinates_outside_texel_space())
        CHECK(disc<16>(clamped(map), outside, 0.9f, 2.0f, rotation) == 1.0f);
}

TEST_CASE("disc_points: less error on edges than Vogel's spiral and Poisson's darts; four turns together, less still") {
    std::mt19937 random(9);
    const auto compare_to = [&](const std::vector<glm::dvec2>& points, double stated, double stated_of_turns) {
        const int count = static_cast<int>(points.size());
        const double error = error_on_edges(points);
        CHECK(std::abs(error - stated) < 0.0004);
        CHECK(error < 0.96 * error_on_edges(vogel(count)));
        double darts = 0;
        for (int i = 0; i < 8; ++i) darts += error_on_edges(poisson(random, count)) / 8;
        CHECK(error < 0.9 * darts);
        std::vector<glm::dvec2> turned;
        for (const glm::dvec2 p : points)
            for (const glm::dvec2 t : {p, glm::dvec2(-p.y, p.x), -p, glm::dvec2(p.y, -p.x)}) turned.push_back(t);
        CHECK(std::abs(error_on_edges(turned) - stated_of_turns) < 0.0004);
    };
    compare_to(ours<8>(), .0562, .0235);
    compare_to(ours<16>(), .0328, .0138);
    compare_to(ours<32>(), .0196, .0083);
}

TEST_CASE("disc: what its values say of themselves, and the pixel decides the rotation") {
    const auto ramp = [](glm::ivec2 t) { return t.x * 3 + t.y * 5 > 40 ? 1.0f : 0.0f; };
    std::set<float> seen;
    for (const filters::disc& filter : filters::disc::values) {
        CHECK(filter.snippet->name == filter.name);
        CHECK(filter.reach() > 2.0f);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                const float share = filter(ramp, glm::vec2(5.0f), 0.5f, {x, y});
                const glm::vec4 rotation = disc_rotation(glm::vec2(float(x), float(y)));
                const float expected = filter.points == 8    ? disc<8>(ramp, glm::vec2(5.0f), 0.5f, 2.0f, rotation)
                                       : filter.points == 16 ? disc<16>(ramp, glm::vec2(5.0f), 0.5f, 2.0f, rotation)
                                                             : disc<32>(ramp, glm::vec2(5.0f), 0.5f, 2.0f, rotation);
                CHECK(share == expected);
                seen.insert(share);
            }
    }
    CHECK(seen.size() > 4);
}
