// SPDX-License-Identifier: MIT
//
// A depth image as an encoding keeps it.
//
//     example::shadow_map map = example::store("rg11", umbrage::upper_edge<float>, depth, 1.0f);
//     float stored = map.depth[texel];
//
#pragma once

#include <string_view>
#include <variant>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

namespace example {

struct shadow_map {
    umbrage::image<float> depth;                                                   ///< decoded
    std::variant<umbrage::image<glm::u8vec3>, umbrage::image<glm::u8vec4>> bytes;  ///< missing channels are 0
    float cleared = 1;                                                             ///< depth of an empty texel
    float below = 0;  ///< largest amount by which a decoded depth lies below the true one
};

/// Encodes and decodes.
/// @param encoding  one of umbrage::encodings, by name
/// @param edge      of a code's interval that decoding answers, for encodings that leave it open
/// @param empty     what `depth` holds where nothing was drawn: it becomes the encoding's own cleared texel
/// @throws std::invalid_argument  no such encoding
[[nodiscard]] shadow_map store(std::string_view encoding, float edge, const umbrage::image<float>& depth, float empty);

}  // namespace example
