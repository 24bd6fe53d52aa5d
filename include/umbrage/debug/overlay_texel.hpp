// SPDX-License-Identifier: MIT
//
// Overlay of a map in a corner of the picture: the texel that a pixel shows, for x and y one by one.
//
//     float column = umbrage::overlay_texel(x + 0.5f, 256.0f, 1024.0f, 1024.0f / 256.0f);  // -1: outside the overlay
//
#pragma once

#include <cmath>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Texel under a pixel's center, along one side of the overlay.
///
/// @param coord             center of the pixel, counted from the corner: 0.5, 1.5, ...
/// @param size              size of the overlay in pixels, an integer
/// @param map_size          size of the map in texels, an integer, at most 65536 in float. The product size map_size
///                          must be at most 2^23 in float and 2^52 in double
/// @param texels_per_pixel  map_size / size, with an error of up to 16 ulp
/// @return                  an integer from 0 to map_size - 1, or -1 outside the overlay
/// @edge                    NaN coord: -1
/// @formula                 floor(coord map_size / size)
/// @exactness               A: the quotient rounds, so its floor may be 1 too low. Products of integers correct it
template <real T>
[[nodiscard]] T overlay_texel(T coord, T size, T map_size, T texels_per_pixel) {
    if (is_nan(coord) || !(coord >= T(0) && coord < size)) return T(-1);
    const T texel = std::floor(coord * texels_per_pixel - T(0.5));
    return (texel + T(1)) * size <= coord * map_size ? texel + T(1) : texel;
}

namespace glsl {

inline constexpr snippet overlay_texel{
    .name = "overlay_texel",
    .summary = "texel under a pixel of a map drawn in the picture's corner",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_overlay_texel: texel under a pixel of a map drawn in the picture's corner; -1.0 outside the overlay
//   coord             center of the pixel, counted from the corner: 0.5, 1.5, ...
//   size              size of the overlay in pixels, an integer
//   map_size          size of the map in texels, an integer, at most 65536.0; times size at most 2^23
//   texels_per_pixel  map_size / size
UMBRAGE_HIGHP float umbrage_overlay_texel(UMBRAGE_HIGHP float coord, UMBRAGE_HIGHP float size,
                                          UMBRAGE_HIGHP float map_size, UMBRAGE_HIGHP float texels_per_pixel) {
    UMBRAGE_HIGHP float texel = floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
}
)GLSL",
};

inline constexpr const snippet* overlay_texel_snippets[]{&overlay_texel};

}  // namespace glsl
}  // namespace umbrage
