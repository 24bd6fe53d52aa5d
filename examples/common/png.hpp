// SPDX-License-Identifier: MIT
//
// Pictures to files. Row 0 of an image becomes the top of the picture; bytes are written as they are.
//
//     example::write_png("out/picture.png", picture);
//
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/image.hpp>

namespace example {

/// @throws std::runtime_error  the file cannot be written
void write_png(const std::filesystem::path& path, umbrage::image_view<const std::uint8_t> grey);
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec3> rgb);
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec4> rgba);

}  // namespace example
