// SPDX-License-Identifier: MIT
#include "png.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace example {
namespace {

template <class T>
void write(const std::filesystem::path& path, umbrage::image_view<const T> pixels) {
    const int channels = static_cast<int>(sizeof(T));
    if (pixels.empty() || !stbi_write_png(path.string().c_str(), pixels.size.x, pixels.size.y, channels, pixels.data,
                                          static_cast<int>(pixels.stride)))
        throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

void write_png(const std::filesystem::path& path, umbrage::image_view<const std::uint8_t> grey) { write(path, grey); }
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec3> rgb) { write(path, rgb); }
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec4> rgba) { write(path, rgba); }

glm::u8vec3 to_srgb(glm::vec3 linear) {
    glm::u8vec3 bytes;
    for (int i = 0; i < 3; ++i) {
        const float v = std::clamp(linear[i], 0.0f, 1.0f);
        const float s = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
        bytes[i] = static_cast<std::uint8_t>(s * 255.0f + 0.5f);
    }
    return bytes;
}

}  // namespace example
