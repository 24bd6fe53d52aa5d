// umbrage 0.1.0, encode_base255_repaired: depth to base-255 RGBA without its faults. Exactness: tier B.
// encode_base255_repaired, tier B: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of base255_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_base255_repaired.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
inline float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_BASE255_REPAIRED
#define UMBRAGE_HAS_ENCODE_BASE255_REPAIRED
// umbrage_encode_base255_repaired: channels of a depth for readers of base-255 RGBA. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
inline float4 umbrage_encode_base255_repaired(float depth) {
    float x = umbrage_saturate(depth) * 255.0;
    float y = (x - metal::floor(x)) * 255.0;
    float z = (y - metal::floor(y)) * 255.0;
    float w = (z - metal::floor(z)) * 255.0;
    return float4(metal::floor(x), metal::floor(y), metal::floor(z), metal::floor(w));
}
#endif
