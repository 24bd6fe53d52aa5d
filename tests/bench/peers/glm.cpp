// SPDX-License-Identifier: MIT
#include "glm.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace peers::glm_code {
namespace {

float fetch(const float_map& map, glm::ivec2 texel) {
    texel = glm::clamp(texel, glm::ivec2(0), map.size - 1);
    return map.texels[static_cast<std::size_t>(texel.y * map.size.x + texel.x)];
}

float lit(const float_map& map, glm::ivec2 texel, float receiver) { return glm::step(receiver, fetch(map, texel)); }

// The radius is known, as in code written for one kernel.
template <int Radius>
void box(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const glm::ivec2 texel(glm::floor(glm::vec2(receivers[i])));
        float sum = 0.0f;
        for (int y = -Radius; y <= Radius; ++y)
            for (int x = -Radius; x <= Radius; ++x) sum += lit(map, texel + glm::ivec2(x, y), receivers[i].z);
        visibility[i] = sum / static_cast<float>((2 * Radius + 1) * (2 * Radius + 1));
    }
}

/// Castano's windows as sums over texels: a row of weights, each texel's blended with its neighbour's.
template <int Size>
void window(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility,
            const std::array<float, Size>& row) {
    float norm = 0.0f;
    for (float k : row) norm += k;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const glm::vec2 position = glm::vec2(receivers[i]) - 0.5f;
        const glm::vec2 base = glm::floor(position), s = position - base;
        const glm::ivec2 first = glm::ivec2(base) - Size / 2;
        glm::vec2 weights[Size + 1];
        for (int k = 0; k <= Size; ++k)
            weights[k] = (k < Size ? row[std::size_t(k)] * (1.0f - s) : glm::vec2(0.0f)) +
                         (k > 0 ? row[std::size_t(k) - 1] * s : glm::vec2(0.0f));
        float sum = 0.0f;
        for (int y = 0; y <= Size; ++y)
            for (int x = 0; x <= Size; ++x)
                sum += weights[y].y * weights[x].x * lit(map, first + glm::ivec2(x, y), receivers[i].z);
        visibility[i] = sum / (norm * norm);
    }
}

}  // namespace

void encode(const std::vector<float>& depth, std::vector<glm::u8vec2>& texels) {
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const float x = glm::min(glm::floor(glm::clamp(depth[i], 0.0f, 1.0f) * 2048.0f), 2047.0f);
        const float high = glm::floor(x / 256.0f);
        texels[i] = glm::u8vec2(glm::vec2(x - high * 256.0f, high * 32.0f));
    }
}

void decode(const std::vector<glm::u8vec2>& texels, std::vector<float>& depth) {
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const glm::vec2 c(texels[i]);
        depth[i] = (c.x + c.y * 8.0f + 1.0f) / 2048.0f;
    }
}

void pcf_2x2(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const glm::vec2 position = glm::vec2(receivers[i]) - 0.5f;
        const glm::vec2 base = glm::floor(position), weight = position - base;
        const glm::ivec2 texel(base);
        const float z = receivers[i].z;
        const float low = glm::mix(lit(map, texel, z), lit(map, texel + glm::ivec2(1, 0), z), weight.x);
        const float high =
            glm::mix(lit(map, texel + glm::ivec2(0, 1), z), lit(map, texel + glm::ivec2(1, 1), z), weight.x);
        visibility[i] = glm::mix(low, high, weight.y);
    }
}

void pcf_box(int radius, const float_map& map, const std::vector<glm::vec3>& receivers,
             std::vector<float>& visibility) {
    constexpr std::array boxes{&box<0>, &box<1>, &box<2>, &box<3>, &box<4>, &box<5>, &box<6>, &box<7>, &box<8>};
    boxes.at(static_cast<std::size_t>(radius))(map, receivers, visibility);
}

void pcf_5x5(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility) {
    box<2>(map, receivers, visibility);
}

void window_3x3(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility) {
    window<3>(map, receivers, visibility, {1, 2, 1});
}
void window_5x5(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility) {
    window<5>(map, receivers, visibility, {1, 3, 4, 3, 1});
}
void window_7x7(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility) {
    window<7>(map, receivers, visibility, {1, 5, 12, 16, 12, 5, 1});
}

namespace {

std::array<glm::vec2, 16> turns() {
    std::array<glm::vec2, 16> all;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const float angle = glm::radians(22.5f * static_cast<float>(k % 4) + 90.0f * static_cast<float>(k / 4));
        all[k] = glm::vec2(glm::cos(angle), glm::sin(angle));
    }
    return all;
}

glm::vec2 turned(glm::vec2 turn, glm::vec2 p) { return {turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y}; }

}  // namespace

void disc_16(const float_map& map, const std::vector<glm::vec3>& receivers, int width, float radius,
             const std::array<glm::vec2, 16>& points, std::vector<float>& visibility) {
    const auto all = turns();
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        const glm::vec2 turn = radius * all[static_cast<std::size_t>((4 * x + y) % 16)];
        float sum = 0.0f;
        for (const glm::vec2 p : points)
            sum += lit(map, glm::ivec2(glm::floor(glm::vec2(receivers[i]) + turned(turn, p))), receivers[i].z);
        visibility[i] = sum / 16.0f;
    }
}

void pcss_16(const float_map& map, const std::vector<glm::vec3>& receivers, int width, float texels_a_depth,
             float least, float widest, const std::array<glm::vec2, 16>& points, std::vector<float>& visibility) {
    const auto all = turns();
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        const glm::vec2 turn = all[static_cast<std::size_t>((4 * x + y) % 16)], at(receivers[i]);
        const float z = receivers[i].z, searched = glm::clamp(z * texels_a_depth, least, widest);
        float sum = 0.0f, count = 0.0f;
        for (const glm::vec2 p : points) {
            const float stored = fetch(map, glm::ivec2(glm::floor(at + searched * turned(turn, p))));
            if (stored < z) sum += stored, count += 1.0f;
        }
        visibility[i] = 1.0f;
        if (count == 0.0f) continue;
        const float radius = glm::clamp((z - sum / count) * texels_a_depth, least, widest);
        float share = 0.0f;
        for (const glm::vec2 p : points) share += lit(map, glm::ivec2(glm::floor(at + radius * turned(turn, p))), z);
        visibility[i] = share / 16.0f;
    }
}

std::array<glm::mat4, 4> cascades(const glm::mat4& camera_view, float tan_half_x, float tan_half_y,
                                  const std::array<float, 5>& splits, glm::vec3 direction, int map_size) {
    std::array<glm::mat4, 4> all;
    const glm::mat4 to_world = glm::inverse(camera_view);
    for (std::size_t i = 0; i < 4; ++i) {
        std::array<glm::vec3, 8> corners;
        glm::vec3 middle(0.0f);
        for (std::size_t k = 0; k < 8; ++k) {
            const float z = splits[i + k / 4], x = k % 2 ? z : -z, y = k / 2 % 2 ? z : -z;
            corners[k] = glm::vec3(to_world * glm::vec4(x * tan_half_x, y * tan_half_y, -z, 1.0f));
            middle += corners[k] / 8.0f;
        }
        float radius = 0.0f;
        for (const glm::vec3& c : corners) radius = glm::max(radius, glm::length(c - middle));
        radius = glm::ceil(radius * 16.0f) / 16.0f;
        const glm::mat4 view = glm::lookAtRH(middle - direction * radius, middle, glm::vec3(0.0f, 1.0f, 0.0f));
        glm::mat4 projection = glm::orthoRH_ZO(-radius, radius, -radius, radius, 0.0f, 2.0f * radius);
        const glm::vec2 origin = glm::vec2((projection * view)[3]) * (static_cast<float>(map_size) * 0.5f);
        const glm::vec2 moved = (glm::round(origin) - origin) * (2.0f / static_cast<float>(map_size));
        projection[3][0] += moved.x;
        projection[3][1] += moved.y;
        all[i] = projection * view;
    }
    return all;
}

}  // namespace peers::glm_code
