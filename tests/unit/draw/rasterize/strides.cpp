// SPDX-License-Identifier: MIT
//
// Rows that contend for the cache are drawn in a copy: the same bits, and none beside the rows.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "../../rounds.hpp"
#include "../../images/isas.hpp"
#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("rasterize_depth: rows any number of bytes apart are drawn like sample by sample, and nothing else is") {
    generator random;
    const glm::ivec2 size(1001, 150);
    mesh m;
    for (int i = 0; i < rounds(600); ++i) {
        const glm::vec2 center{random.real(-1.1f, 1.1f), random.real(-1.1f, 1.1f)};
        std::array<glm::vec3, 3> corner;
        for (auto& c : corner) {
            const glm::vec2 to{random.real(-0.15f, 0.15f), random.real(-0.9f, 0.9f)};
            c = {center + to, random.real(0.1f, 0.9f)};
        }
        m.add(corner[0], corner[1], corner[2]);
    }
    for (auto direction : {depth_direction::forward, depth_direction::reversed})
        for (auto origin : {texture_origin::bottom, texture_origin::top})
            for (const int bytes : {4096, 6144, 4096 + 64, -4096}) {
                const clip_space clip{.range = depth_range::zero_to_one, .direction = direction, .origin = origin};
                const std::size_t stride = std::size_t(std::abs(bytes)) / sizeof(float), offset = 5;
                std::vector<float> memory(offset + stride * std::size_t(size.y));
                for (float& z : memory)
                    z = random(0, 3) ? cleared_depth(clip) : std::bit_cast<float>(unsigned(random.engine()));
                const auto view_of = [&](std::vector<float>& floats) {
                    float* const lowest = floats.data() + offset;
                    return image_view<float>(bytes < 0 ? lowest + stride * std::size_t(size.y - 1) : lowest, size,
                                             bytes);
                };
                std::vector<float> reference = memory;
                rasterize(size, m, glm::mat4(1.0f), clip, [&](glm::ivec2 texel, float z, unsigned) {
                    float& there = view_of(reference)[texel];
                    if (direction == depth_direction::forward ? z <= there : z >= there) there = z;
                });
                for_each_isa([&] {
                    std::vector<float> alone = memory, in_pieces = memory;
                    const auto same = [&](const std::vector<float>& drawn) {
                        return std::equal(drawn.begin(), drawn.end(), reference.begin(), [](float a, float b) {
                            return std::bit_cast<unsigned>(a) == std::bit_cast<unsigned>(b);
                        });
                    };
                    rasterize_depth(view_of(alone), m, glm::mat4(1.0f), clip);
                    CHECK(same(alone));
                    rasterize_depth(view_of(in_pieces), m, glm::mat4(1.0f), clip, cull_mode::none,
                                    [](int count, auto&& piece) {
                                        piece(count / 2, count);
                                        piece(0, count / 2);
                                    });
                    CHECK(same(in_pieces));
                });
            }
}
