// umbrage 0.1.0, decode_float_bits: four channels, R least significant, to the float they hold. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of float_bits: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (0, 0, 128, 63) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_float_bits.
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

#ifndef UMBRAGE_HAS_DECODE_FLOAT_BITS
#define UMBRAGE_HAS_DECODE_FLOAT_BITS
// umbrage_decode_float_bits: float from the four channels of its bit pattern, as sampled, R least significant
UMBRAGE_HIGHP float umbrage_decode_float_bits(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return uintBitsToFloat(r | (g << 8) | (b << 16) | (a << 24));
}
#endif
