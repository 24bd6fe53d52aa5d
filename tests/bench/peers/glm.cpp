// SPDX-License-Identifier: MIT
#include "glm.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>

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

}  // namespace peers::glm_code
