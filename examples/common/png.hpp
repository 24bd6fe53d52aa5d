// SPDX-License-Identifier: MIT
//
// Pictures to files and back. Row 0 of an image becomes the top of the picture; bytes are written as they are.
//
//     example::write_png("out/picture.png", picture);
//     const umbrage::image<glm::u8vec3> same = example::read_png<glm::u8vec3>("out/picture.png");
//
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>

namespace example {

enum class file_size { quick, smallest };  ///< smallest: a second or so for what others read again and again

/// @throws std::runtime_error  the file cannot be written
void write_png(const std::filesystem::path& path, umbrage::image_view<const std::uint8_t> gray);
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec3> rgb,
               file_size wanted = file_size::quick);
void write_png(const std::filesystem::path& path, umbrage::image_view<const glm::u8vec4> rgba);

/// @tparam Texel  glm::u8vec3, or glm::u8vec4 with 255 where the file has no opacity
/// @throws std::runtime_error  there is no such picture
template <class Texel>
[[nodiscard]] umbrage::image<Texel> read_png(const std::filesystem::path& path);
extern template umbrage::image<glm::u8vec3> read_png(const std::filesystem::path&);
extern template umbrage::image<glm::u8vec4> read_png(const std::filesystem::path&);

}  // namespace example
