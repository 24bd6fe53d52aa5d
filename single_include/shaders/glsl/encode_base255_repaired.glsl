// umbrage 0.1.0, encode_base255_repaired: depth to base-255 RGBA without its faults. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// encode_base255_repaired, tier B: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of base255_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_base255_repaired.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
UMBRAGE_HIGHP float umbrage_saturate(UMBRAGE_HIGHP float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_BASE255_REPAIRED
#define UMBRAGE_HAS_ENCODE_BASE255_REPAIRED
// umbrage_encode_base255_repaired: channels of a depth for readers of base-255 RGBA. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_base255_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = umbrage_saturate(depth) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (x - floor(x)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (y - floor(y)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (z - floor(z)) * 255.0;
    return vec4(floor(x), floor(y), floor(z), floor(w));
}
#endif
