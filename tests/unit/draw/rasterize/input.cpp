// SPDX-License-Identifier: MIT
//
// Input that is empty, degenerate, not finite or out of range.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("rasterize_depth: bad input") {
    const glm::ivec2 size(8, 8);
    mesh m;
    m.add({-1, -1, 0.5f}, {3, -1, 0.5f}, {-1, 3, 0.5f});

    SUBCASE("an index out of range throws before anything is drawn") {
        for (int corner = 0; corner < 3; ++corner)
            for (unsigned index : {3u, ~0u}) {
                mesh broken = m;
                broken.triangles.emplace_back(0, 1, 2);
                broken.triangles.back()[corner] = index;
                image<float> depth(size, 1.0f);
                CHECK_THROWS_AS(rasterize_depth(depth, broken, glm::mat4(1.0f), cpu_clip_space), std::invalid_argument);
                CHECK(all(depth, 1.0f));
            }
    }
    SUBCASE("a triangle with NaN or infinity is left out, the others are drawn") {
        for (float bad : {nan_value, -nan_value, infinity, -infinity})
            for (int corner = 0; corner < 3; ++corner)
                for (int component = 0; component < 3; ++component) {
                    mesh broken;
                    broken.add({-1, -1, 0.25f}, {3, -1, 0.25f}, {-1, 3, 0.25f});
                    broken.positions[std::size_t(corner)][component] = bad;
                    CHECK(all(render(size, broken), 1.0f));
                    broken.add(m.positions[0], m.positions[1], m.positions[2]);
                    CHECK(all(render(size, broken), 0.5f));
                }
    }
    SUBCASE("a matrix with NaN or infinity draws nothing, wild ones do no harm") {
        for (float bad : {nan_value, infinity, -infinity})
            for (int i = 0; i < 16; ++i) {
                glm::mat4 matrix(1.0f);
                matrix[i / 4][i % 4] = bad;
                CHECK(all(render(size, m, matrix), 1.0f));
            }
        generator random;
        constexpr float largest = std::numeric_limits<float>::max();
        constexpr float smallest = std::numeric_limits<float>::denorm_min();
        const std::array<float, 9> wild{0.0f, -0.0f, 1.0f, -1.0f, largest, -largest, smallest, -smallest, 1e-30f};
        const auto pick = [&] { return wild[std::size_t(random(0, 8))]; };
        int samples = 0;
        for (int round = 0; round < 20000; ++round) {
            glm::mat4 matrix;
            for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = pick();
            mesh any;
            any.add({pick(), pick(), pick()}, {pick(), pick(), pick()}, {pick(), pick(), pick()});
            const auto range = round % 2 ? depth_range::zero_to_one : depth_range::minus_one_to_one;
            rasterize(size, any, matrix, {.range = range}, [&](glm::ivec2 texel, float z, unsigned) {
                samples += texel.x >= 0 && texel.y >= 0 && texel.x < 8 && texel.y < 8 && z >= 0.0f && z <= 1.0f;
                samples -= std::signbit(z) ? 1000000 : 0;
            });
        }
        CHECK(samples > 0);
    }
    SUBCASE("nothing to draw, or nowhere") {
        CHECK(all(render(size, mesh{}), 1.0f));
        mesh degenerate;
        degenerate.add({-1, -1, 0.5f}, {1, 1, 0.5f}, {0, 0, 0.5f});
        degenerate.add({0, 0, 0.5f}, {0, 0, 0.5f}, {1, 0, 0.5f});
        degenerate.add({0.0625f, 0.0625f, 0.5f}, {0.0626f, 0.0625f, 0.5f}, {0.0625f, 0.0626f, 0.5f});  // snap together
        CHECK(all(render(size, degenerate), 1.0f));
        for (glm::ivec2 none : {glm::ivec2(0, 0), glm::ivec2(0, 8), glm::ivec2(8, 0)}) {
            image<float> empty(none);
            rasterize_depth(empty, m, glm::mat4(1.0f), cpu_clip_space);
        }
        rasterize_depth({}, m, glm::mat4(1.0f), cpu_clip_space);
    }
    SUBCASE("sizes that the grid has no room for") {
        image<float> wide_image({detail::guard_band + 1, 1}), tall_image({1, detail::guard_band + 1});
        CHECK_THROWS_AS(rasterize_depth(wide_image, m, glm::mat4(1.0f), cpu_clip_space), std::invalid_argument);
        CHECK_THROWS_AS(rasterize_depth(tall_image, m, glm::mat4(1.0f), cpu_clip_space), std::invalid_argument);
        const auto ignore = [](glm::ivec2, float, unsigned) {};
        CHECK_THROWS_AS(rasterize({-1, 4}, m, glm::mat4(1.0f), cpu_clip_space, ignore), std::invalid_argument);
    }
    SUBCASE("a stride leaves the texels between rows alone") {
        std::vector<float> pixels(10 * 8, 7.0f);
        image_view<float> view(pixels.data(), size, 10 * sizeof(float));
        rasterize_depth(view, m, glm::mat4(1.0f), cpu_clip_space);
        for (std::size_t i = 0; i < pixels.size() - 2; ++i) CHECK(pixels[i] == (i % 10 < 8 ? 0.5f : 7.0f));
        image_view<float> upside_down(pixels.data() + 70, size, -10 * std::ptrdiff_t(sizeof(float)));
        mesh lower_half;
        lower_half.add({-9, 0, 0.25f}, {9, 0, 0.25f}, {0, -9, 0.25f});
        rasterize_depth(upside_down, lower_half, glm::mat4(1.0f), cpu_clip_space);
        CHECK(pixels[74] == 0.25f);
        CHECK(pixels[4] == 0.5f);
    }
}
