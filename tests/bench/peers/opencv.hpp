// SPDX-License-Identifier: MIT
//
// OpenCV on one thread of this machine.
#pragma once

#include <cstdint>
#include <span>

#include <umbrage/core/image.hpp>

namespace peers::opencv {

/// GaussianBlur, or sepFilter2D with the same kernel, 7 taps; the border goes on outside.
void gaussian_7(umbrage::image_view<const glm::vec2> from, umbrage::image_view<glm::vec2> to, double sigma);
void separable_7(umbrage::image_view<const glm::vec2> from, umbrage::image_view<glm::vec2> to,
                 std::span<const float, 7> kernel);

/// integral(): tables are one larger each way, with zeros first.
void integral(umbrage::image_view<const std::uint8_t> values, umbrage::image_view<std::uint32_t> sums);
void integral(umbrage::image_view<const float> values, umbrage::image_view<float> sums);

}  // namespace peers::opencv
