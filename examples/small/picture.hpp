// SPDX-License-Identifier: MIT
//
// Writes a picture of gray values as a PNG.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <umbrage/core/image.hpp>

/// @param light   linear light, 0 to 1; row 0 becomes the top
inline void write_picture(const char* file, const umbrage::image<float>& light) {
    std::vector<std::uint8_t> bytes;
    for (const float v : light.texels())
        bytes.push_back(
            static_cast<std::uint8_t>(255 * std::pow(std::fmin(std::fmax(v, 0.0f), 1.0f), 1 / 2.2f) + 0.5f));
    stbi_write_png(file, light.size().x, light.size().y, 1, bytes.data(), light.size().x);
}
