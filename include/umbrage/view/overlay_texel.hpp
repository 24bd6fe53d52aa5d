// SPDX-License-Identifier: MIT
//
// A map stretched over the picture's corner: which of its texels a pixel shows, along x and along y.
//
//     float column = umbrage::overlay_texel(x + 0.5f, 256.0f, 1024.0f, 1024.0f / 256.0f);  // -1: beside the overlay
//
#pragma once

#include <cmath>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// The texel that lies under a pixel's center.
///
/// @param coord             center of the pixel, counted from the corner: 0.5, 1.5, ...
/// @param size              of the overlay in pixels, whole
/// @param map_size          of the map in texels, whole, at most 65536 in float; size map_size at most 2^23 in float,
///                          2^52 in double
/// @param texels_per_pixel  map_size / size, up to 16 ulp off
/// @return                  whole, from 0 to map_size - 1; -1 outside the overlay, and for NaN
/// @formula                 floor(coord map_size / size)
/// @exactness               A: the quotient is rounded, so its floor less 0 or 1 is taken, and products of whole
///                          numbers tell which
template <real T>
[[nodiscard]] T overlay_texel(T coord, T size, T map_size, T texels_per_pixel) {
    if (is_nan(coord) || !(coord >= T(0) && coord < size)) return T(-1);
    const T texel = std::floor(coord * texels_per_pixel - T(0.5));
    return (texel + T(1)) * size <= coord * map_size ? texel + T(1) : texel;
}

namespace glsl {

inline constexpr snippet overlay_texel{
    .name = "overlay_texel",
    .summary = "which texel of a map stretched over the picture's corner a pixel shows, along one side",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_overlay_texel: texel under a pixel of a map stretched over the picture's corner; -1.0 outside the overlay
//   coord     center of the pixel, counted from the corner: 0.5, 1.5, ...;   size  of the overlay in pixels, whole
//   map_size  in texels, whole, at most 65536.0; times size at most 2^23;   texels_per_pixel  map_size / size
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
