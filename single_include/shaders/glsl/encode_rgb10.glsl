// umbrage 0.1.0, encode_rgb10: depth to three 10-bit channels, R most significant. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb10: RGB10_A2 UNORM, not sRGB, no blending, one sample. Clear to (1023, 1023, 960) / 1023, with
//   reversed depth to (0, 0, 0) / 1023. Write umbrage_to_unorm10 of umbrage_encode_rgb10.
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

#ifndef UMBRAGE_HAS_ENCODE_RGB10
#define UMBRAGE_HAS_ENCODE_RGB10
// umbrage_encode_rgb10: three channels of a depth, R most significant, integers 0..1023 for umbrage_to_unorm10
// The last four bits are the high ones of B, so a target cleared to white is at the far plane
//   depth   clamped to [0, 1]. NaN counts as far
UMBRAGE_HIGHP vec3 umbrage_encode_rgb10(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 16384.0));
    UMBRAGE_HIGHP float rest = x - high * 16384.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 16.0));
    UMBRAGE_HIGHP float low = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return vec3(high, middle, low * 64.0);
}
#endif
