// umbrage 0.1.0, encode_threejs_legacy_repaired: depth to three.js RGBA, r73 to r166, without its fault. Exactness:
//   tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_legacy_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255,
//   255) / 255, with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of
//   umbrage_encode_threejs_legacy_repaired.
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

#ifndef UMBRAGE_HAS_ENCODE_THREEJS_LEGACY_REPAIRED
#define UMBRAGE_HAS_ENCODE_THREEJS_LEGACY_REPAIRED
// umbrage_encode_threejs_legacy_repaired: channels of a depth for readers of three.js r73 to r166. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
inline float4 umbrage_encode_threejs_legacy_repaired(float depth) {
    float v = umbrage_saturate(depth);
    float x = metal::floor(v * 16777216.0);
    float high = metal::floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = metal::floor(rest * (1.0 / 256.0));
    float low = metal::min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? float4(0.0, low, middle, high) : float4(255.0, 255.0, 255.0, 255.0);
}
#endif
