// umbrage 0.1.0, decode_rg10: two 8-bit channels, R the low byte, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rg10: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 192) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg10.

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

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
UMBRAGE_HIGHP float umbrage_from_unorm(UMBRAGE_HIGHP float c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 255.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG10
#define UMBRAGE_HAS_DECODE_RG10
// umbrage_decode_rg10: depth from the two channels of a 10-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
UMBRAGE_HIGHP float umbrage_decode_rg10(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
#endif
