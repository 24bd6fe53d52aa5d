// SPDX-License-Identifier: MIT
//
// Text as coverage of pixels, in a real font: Open Sans, of Debian's fonts-open-sans.
#pragma once

#include <string_view>

#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>

namespace pictures {

inline constexpr int letter_height = 17, line_height = 21;  ///< pixels, of a letter with ascender and descender

/// How much of each pixel the text covers, 0 to 1. The first line's top is at row 0.
/// @param text  ASCII
[[nodiscard]] umbrage::image<float> lettering(std::string_view text);

}  // namespace pictures
