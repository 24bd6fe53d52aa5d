// umbrage 0.1.0, encode_rg16: depth to two 8-bit channels, R the low byte. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rg16: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg16.
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

#ifndef UMBRAGE_HAS_ENCODE_RG16
#define UMBRAGE_HAS_ENCODE_RG16
// umbrage_encode_rg16: two channels of a 16-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg16(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 1.0);
}
#endif
