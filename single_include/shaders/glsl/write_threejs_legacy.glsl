// umbrage 0.1.0, write_threejs_legacy: depth to three.js RGBA, r73 to r166. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// write_threejs_legacy, tier B: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_legacy: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255, 255) /
//   255, with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_threejs_legacy.
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

#ifndef UMBRAGE_HAS_WRITE_THREEJS_LEGACY
#define UMBRAGE_HAS_WRITE_THREEJS_LEGACY
// umbrage_write_threejs_legacy: RGBA of a depth, as in three.js r73 to r166, values to write as they are
//   1.0 reads back as 255/256. umbrage_encode_threejs_legacy_repaired does not have this fault
UMBRAGE_HIGHP vec4 umbrage_write_threejs_legacy(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0 - floor(v * 16777216.0);
    UMBRAGE_HIGHP float y = v * 65536.0 - floor(v * 65536.0);
    UMBRAGE_HIGHP float z = v * 256.0 - floor(v * 256.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = vec4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
#endif
