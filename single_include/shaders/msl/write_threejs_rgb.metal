// umbrage 0.1.0, write_threejs_rgb: depth to three.js RGB, r167 and later. Exactness: tier B.
// write_threejs_rgb, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_rgb: RGB8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255) / 255, with
//   reversed depth to (0, 0, 0) / 255. Write umbrage_write_threejs_rgb.
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

#ifndef UMBRAGE_HAS_WRITE_THREEJS_RGB
#define UMBRAGE_HAS_WRITE_THREEJS_RGB
// umbrage_write_threejs_rgb: RGB of a depth, as in three.js r167 and later, values to write as they are
inline float3 umbrage_write_threejs_rgb(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 65536.0;
    float whole = metal::floor(x);
    float high = metal::floor(whole * (1.0 / 256.0));
    float3 c = float3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : float3(1.0, 1.0, 1.0);
}
#endif
