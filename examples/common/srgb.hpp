// SPDX-License-Identifier: MIT
//
// Linear light to the bytes that screens expect.
//
//     glm::u8vec3 pixel = example::to_srgb(linear);
//
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>

namespace example {

/// The curve of sRGB, to a byte.
/// @param linear  in [0, 1]
[[nodiscard]] inline std::uint8_t srgb_curve(float linear) {
    const float s = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    return static_cast<std::uint8_t>(s * 255.0f + 0.5f);
}

/// The same bytes without a power: the curve is steepest at 0, where a cell sees at most one of its 255 steps.
class srgb_table {
public:
    srgb_table() {
        for (std::size_t byte = 1; byte < 256; ++byte) {
            float below = 0, least = 1;  // srgb_curve(below) < byte <= srgb_curve(least), neighbors in the end
            while (std::nextafter(below, 1.0f) < least) {
                const float middle = 0.5f * (below + least);
                (srgb_curve(middle) < byte ? below : least) = middle;
            }
            least_[byte] = least;
        }
        least_[256] = std::numeric_limits<float>::infinity();
        for (std::size_t cell = 0; cell <= cells; ++cell)
            byte_[cell] = srgb_curve(static_cast<float>(cell) / static_cast<float>(cells));
    }

    [[nodiscard]] std::uint8_t operator()(float linear) const {
        const float v = linear > 0 ? std::min(linear, 1.0f) : 0.0f;
        const std::uint8_t byte = byte_[static_cast<std::size_t>(v * static_cast<float>(cells))];
        return static_cast<std::uint8_t>(byte + (v >= least_[byte + std::size_t(1)]));
    }

private:
    static constexpr std::size_t cells = 4096;
    std::array<float, 257> least_{};              ///< linear value that a byte begins with
    std::array<std::uint8_t, cells + 1> byte_{};  ///< of the least value in a cell
};

/// @param linear  clamped to [0, 1]
[[nodiscard]] inline glm::u8vec3 to_srgb(glm::vec3 linear) {
    static const srgb_table table;
    return {table(linear.r), table(linear.g), table(linear.b)};
}

}  // namespace example
