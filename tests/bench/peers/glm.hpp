// SPDX-License-Identifier: MIT
//
// The code that a user would write with GLM, one texel after the other.
#pragma once

#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace peers::glm_code {

struct float_map {
    std::vector<float> texels;
    glm::ivec2 size;
};

/// `codes` of 11 bits, R the low byte, G the high bits at the top of theirs.
void encode(const std::vector<float>& depth, std::vector<glm::u8vec2>& texels);
void decode(const std::vector<glm::u8vec2>& texels, std::vector<float>& depth);

/// Visibility by 2x2 comparisons, bilinear weights in floats.
void pcf_2x2(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility);
/// Visibility by comparisons of equal weight, 2 radius + 1 in a row, radius 0 .. 8; one function for each radius.
void pcf_box(int radius, const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility);
void pcf_5x5(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility);

}  // namespace peers::glm_code
