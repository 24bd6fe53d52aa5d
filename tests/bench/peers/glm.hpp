// SPDX-License-Identifier: MIT
//
// The code that a user would write with GLM, one texel after the other.
#pragma once

#include <array>
#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
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
/// Visibility by comparisons of texels under weights 1 2 1, 1 3 4 3 1 and 1 5 12 16 12 5 1, which slide over the map.
void window_3x3(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility);
void window_5x5(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility);
void window_7x7(const float_map& map, const std::vector<glm::vec3>& receivers, std::vector<float>& visibility);
/// Visibility by comparisons with points of a disc, which turns by 22.5 degrees from pixel to pixel of a 4 x 4 block.
/// @param width   of the image that the receivers are one of;   points  in radii
void disc_16(const float_map& map, const std::vector<glm::vec3>& receivers, int width, float radius,
             const std::array<glm::vec2, 16>& points, std::vector<float>& visibility);

/// Percentage-closer soft shadows over such a disc: the mean of what is nearer, a penumbra in proportion to the gap.
/// @param texels_a_depth   radius of the penumbra, from blockers a depth of 1 before the receiver
/// @param least, widest    radii of the filter and the search
void pcss_16(const float_map& map, const std::vector<glm::vec3>& receivers, int width, float texels_a_depth,
             float least, float widest, const std::array<glm::vec2, 16>& points, std::vector<float>& visibility);

/// Light matrices of four cascades of a camera, as tutorials have them: the corners of a part of the frustum, the
/// sphere around their mean, its middle moved to whole texels of the light's own view; in floats.
std::array<glm::mat4, 4> cascades(const glm::mat4& camera_view, float tan_half_x, float tan_half_y,
                                  const std::array<float, 5>& splits, glm::vec3 direction, int map_size);

}  // namespace peers::glm_code
