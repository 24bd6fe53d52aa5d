// umbrage 0.1.0, overlay_texel: texel under a pixel of a map drawn in the picture's corner. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_OVERLAY_TEXEL
#define UMBRAGE_HAS_OVERLAY_TEXEL
// umbrage_overlay_texel: texel under a pixel of a map drawn in the picture's corner; -1.0 outside the overlay
//   coord             center of the pixel, counted from the corner: 0.5, 1.5, ...
//   size              size of the overlay in pixels, an integer
//   map_size          size of the map in texels, an integer, at most 65536.0; times size at most 2^23
//   texels_per_pixel  map_size / size
float umbrage_overlay_texel(float coord, float size, float map_size, float texels_per_pixel) {
    float texel = floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
}
#endif
