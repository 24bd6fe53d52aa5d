// umbrage 0.1.0, decode_rgb10: three 10-bit channels, R most significant, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb10: RGB10_A2 UNORM, not sRGB, no blending, one sample. Clear to (1023, 1023, 960) / 1023, with
//   reversed depth to (0, 0, 0) / 1023. Write umbrage_to_unorm10 of umbrage_encode_rgb10.

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

#ifndef UMBRAGE_HAS_FROM_UNORM10
#define UMBRAGE_HAS_FROM_UNORM10
// umbrage_from_unorm10: channel 0..1023 of a value from a 10-bit texture, even if the division by 1023 is inexact
UMBRAGE_HIGHP float umbrage_from_unorm10(UMBRAGE_HIGHP float c) {
    return floor(c * 1023.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm10(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 1023.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm10(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 1023.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm10(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 1023.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RGB10
#define UMBRAGE_HAS_DECODE_RGB10
// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
UMBRAGE_HIGHP float umbrage_decode_rgb10(UMBRAGE_HIGHP vec3 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
#endif
