// SPDX-License-Identifier: MIT
//
// Samples that a triangle covers, compared with the oracle.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "../../rounds.hpp"
#include "exact.hpp"
#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("rasterize: coverage is the oracle's, for corners and edges on texel centers too, in perspective too") {
    generator random;
    const glm::ivec2 size(40, 24);
    int on_center = 0, samples = 0, wrong = 0;
    for (int round = 0; round < rounds(20000); ++round) {
        const exact_scene scene({0, 0, 2048, 0});
        exact_triangle oracle;
        mesh m;
        std::array<glm::vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            const int w = round % 2 ? random(16, 200) : 64;
            int x = random(-3 * w / 2, 3 * w / 2), y = random(-3 * w / 2, 3 * w / 2);
            if (round % 4 == 0) x = y = random(-70, 70);  // corners on a diagonal, many shared or collinear
            oracle.v[i] = scene.vertex(x, y, w);
            oracle.v[i].snap(size);
            on_center += oracle.v[i].column % 256 == 128 && oracle.v[i].row % 256 == 128;
            p[i] = scene.position(x, y, w);
        }
        m.add(p[0], p[1], p[2]);
        const auto count = count_samples(size, m, scene.matrix);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                wrong += count[{x, y}] != (oracle.covers({x, y}) ? 1 : 0);
                samples += count[{x, y}];
            }
    }
    CHECK(wrong == 0);
    CHECK(on_center > rounds(100));
    CHECK(samples > rounds(1000000));

    // corners on a quarter-texel grid, so that most edges meet centers
    int ties = 0;
    for (int round = 0; round < rounds(20000); ++round) {
        const glm::ivec2 small(16, 8);
        exact_triangle oracle;
        std::array<glm::vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            const int step = round % 3 == 0 ? 128 : 64;
            const int x = step * random(-8, 16 * 256 / step + 8), y = step * random(-8, 8 * 256 / step + 8);
            oracle.v[i] = {0, 0, 0, 1, x, y};
            p[i] = at(x, y, small);
        }
        mesh m;
        m.add(p[0], p[1], p[2]);
        const auto count = count_samples(small, m);
        for (int y = 0; y < small.y; ++y)
            for (int x = 0; x < small.x; ++x) {
                wrong += count[{x, y}] != (oracle.covers({x, y}) ? 1 : 0);
                for (std::size_t i = 0; i < 3; ++i) ties += count[{x, y}] && oracle.part(i, {x, y}) == 0;
            }
    }
    CHECK(wrong == 0);
    CHECK(ties > rounds(5000));
}

TEST_CASE("rasterize: each sample on a shared edge or corner is covered exactly once") {
    generator random;
    const glm::ivec2 size(24, 20);
    for (int round = 0; round < rounds(600); ++round) {
        mesh m;
        if (round % 2) {  // a grid over the image; its inner corners moved, a third of them onto texel centers
            const int columns = 7, rows = 6;
            const auto coordinate = [&](int i, int last, int texels) {
                if (i == 0) return -256;
                if (i == last) return (texels + 1) * 256;
                const int regular = 256 * texels * i / last, moved = regular + random(-200, 200);
                return round % 3 ? moved : (moved & ~255) + 128;
            };
            for (int y = 0; y <= rows; ++y)
                for (int x = 0; x <= columns; ++x)
                    m.positions.push_back(at(coordinate(x, columns, size.x), coordinate(y, rows, size.y), size));
            for (unsigned y = 0; y < rows; ++y)
                for (unsigned x = 0; x < columns; ++x) {
                    const unsigned i = y * (columns + 1) + x, above = i + columns + 1;
                    const bool rising = random(0, 1) == 1;
                    m.triangles.emplace_back(i, i + 1, rising ? above + 1 : above);
                    m.triangles.emplace_back(above + 1, above, rising ? i : i + 1);
                }
        } else {  // a fan around a texel's center, its rim on centers outside of the image
            const int column = 256 * random(0, 23) + 128, row = 256 * random(0, 19) + 128;
            const int left = -640, right = 26 * 256 + 128, bottom = -640, top = 22 * 256 + 128;
            m.positions.push_back(at(column, row, size));
            std::vector<glm::ivec2> rim{{left, bottom}, {right, bottom}, {left, top}, {right, top}};
            for (int i = 0; i < 40; ++i) {
                const int along_x = 256 * random(-2, 25) + 128, along_y = 256 * random(-2, 21) + 128;
                rim.insert(rim.end(), {{along_x, bottom}, {along_x, top}, {left, along_y}, {right, along_y}});
            }
            const auto angle = [](glm::ivec2 p) { return std::atan2(double(p.y - 2560), double(p.x - 3072)); };
            std::sort(rim.begin(), rim.end(), [&](auto a, auto b) { return angle(a) < angle(b); });
            for (auto p : rim) m.positions.push_back(at(p.x, p.y, size));
            for (unsigned i = 1; i <= rim.size(); ++i) m.triangles.emplace_back(0, i, i % rim.size() + 1);
        }
        for (auto& t : m.triangles)
            if (random(0, 1)) std::swap(t.x, t.y);
        const auto count = count_samples(size, m);
        CHECK(std::all_of(count.texels().begin(), count.texels().end(), [](int n) { return n == 1; }));
    }
}
