// umbrage 0.1.0, encode_threejs_legacy_repaired: depth to three.js RGBA, r73 to r166, without its fault. Exactness:
//   tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_legacy_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255,
//   255) / 255, with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of
//   umbrage_encode_threejs_legacy_repaired.
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

#ifndef UMBRAGE_HAS_ENCODE_THREEJS_LEGACY_REPAIRED
#define UMBRAGE_HAS_ENCODE_THREEJS_LEGACY_REPAIRED
// umbrage_encode_threejs_legacy_repaired: channels of a depth for readers of three.js r73 to r166. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_threejs_legacy_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = floor(v * 16777216.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    UMBRAGE_HIGHP float low = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? vec4(0.0, low, middle, high) : vec4(255.0, 255.0, 255.0, 255.0);
}
#endif
