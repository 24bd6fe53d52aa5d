// SPDX-License-Identifier: MIT
//
// Whole depth images into texels of an encoding, and back.
//
//     umbrage::image<glm::u8vec2> packed(depth.size());
//     umbrage::encode(depth.view(), packed.view(), umbrage::rg<11>{});
//
#pragma once

#include <stdexcept>

#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/image.hpp>

namespace umbrage {

/// @param depth      any values; what the encoding makes of them
/// @param texels     same size
/// @param encoding   rg<Bits>, rgb24, float_bits, depth32f, or a type like them
/// @throws std::invalid_argument  sizes differ
template <class Encoding>
void encode(image_view<const float> depth, image_view<typename Encoding::texel> texels, Encoding encoding) {
    if (depth.size != texels.size) throw std::invalid_argument("umbrage::encode: sizes differ");
    if (depth.empty()) return;
    for (int y = 0; y < depth.size.y; ++y) {
        const float* from = depth.row(y);
        typename Encoding::texel* to = texels.row(y);
        for (int x = 0; x < depth.size.x; ++x) to[x] = encoding.encode(from[x]);
    }
}

/// @param texels     any texels of the encoding
/// @param depth      same size
/// @throws std::invalid_argument  sizes differ
template <class Encoding>
void decode(image_view<const typename Encoding::texel> texels, image_view<float> depth, Encoding encoding) {
    if (depth.size != texels.size) throw std::invalid_argument("umbrage::decode: sizes differ");
    if (depth.empty()) return;
    for (int y = 0; y < depth.size.y; ++y) {
        const typename Encoding::texel* from = texels.row(y);
        float* to = depth.row(y);
        for (int x = 0; x < depth.size.x; ++x) to[x] = encoding.decode(from[x]);
    }
}

}  // namespace umbrage
