// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/images/depth_span.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/light/light_space.hpp>

using namespace umbrage;

TEST_CASE("measure_depths: the least and the greatest of what was drawn, however the rows are cut") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> depth(-3.0f, 3.0f);
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 5), glm::ivec2(64, 2), glm::ivec2(131, 37)})
        for (const float cleared : {1.0f, 0.0f}) {
            image<float> map(size, cleared);
            for (float& texel : map.texels()) {
                if (random() % 3 == 0) texel = depth(random);
                if (random() % 50 == 0) texel = std::nanf("");
            }
            std::vector<float> drawn;
            for (const float texel : map.texels())
                if (!std::isnan(texel) && texel != cleared) drawn.push_back(texel);
            const auto odd = [](int count, auto&& piece) {
                for (int i = count; i > 0; i -= 3) piece(std::max(i - 3, 0), i);
            };
            for (const depth_span span : {measure_depths(map, cleared), measure_depths(map, cleared, odd)}) {
                CHECK(span.empty() == drawn.empty());
                if (drawn.empty()) continue;
                CHECK(span.least == *std::min_element(drawn.begin(), drawn.end()));
                CHECK(span.greatest == *std::max_element(drawn.begin(), drawn.end()));
            }
        }
}

TEST_CASE("measure_depths: nothing drawn, and no image, are empty") {
    const float infinity = std::numeric_limits<float>::infinity();
    image<float> map({70, 3}, 1.0f);
    CHECK(measure_depths(map, 1.0f).empty());
    CHECK(measure_depths(image_view<const float>(), 1.0f).empty());
    map[{69, 2}] = infinity;
    map[{0, 0}] = -infinity;
    CHECK(measure_depths(map, 1.0f).least == -infinity);
    CHECK(measure_depths(map, 1.0f).greatest == infinity);
}

TEST_CASE("seen_range: walls at 3 and 60 in front of a camera, forward and reversed, with and without a far plane") {
    const std::vector<glm::vec3> positions{{-1, -1, -3},    {1, -1, -3},    {0, 1, -3},
                                           {-90, -90, -60}, {90, -90, -60}, {0, 90, -60}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {3, 4, 5}};
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        for (const float z_far : {1000.0f, std::numeric_limits<float>::infinity()}) {
            const clip_space clip{.range = depth_range::zero_to_one, .direction = direction};
            image<float> map({64, 64}, cleared_depth(clip));
            rasterize_depth(map, {positions, triangles}, perspective(1.0f, 1.0f, 0.1f, z_far, clip), clip);
            const glm::vec2 range = seen_range(measure_depths(map, cleared_depth(clip)), 0.1f, z_far, direction);
            CHECK(range.x <= 3.0f);
            CHECK(range.x >= 3.0f * 0.998f);
            CHECK(range.y >= 60.0f);
            CHECK(range.y <= 60.0f * 1.002f);
            CHECK(seen_range(depth_span{}, 0.1f, z_far, direction) == glm::vec2(0.1f, z_far));
        }
    CHECK(seen_range(depth_span{0.0f, 1.0f}, 0.1, 9.0, depth_direction::forward) == glm::dvec2(0.1, 9.0));
}
