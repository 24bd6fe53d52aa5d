// umbrage 0.1.0, decode_deviation_rgba8: mean and deviation in RGBA8 to two moments (VSM). Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// decode_deviation_rgba8, tier B: within 21 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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

#ifndef UMBRAGE_HAS_DECODE_DEVIATION
#define UMBRAGE_HAS_DECODE_DEVIATION
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation(UMBRAGE_HIGHP vec2 held) {
    UMBRAGE_HIGHP float half_of_it = held.y * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = held.x * held.x + half_of_it * half_of_it;
    return vec2(held.x, square);
}
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

#ifndef UMBRAGE_HAS_DECODE_RG16
#define UMBRAGE_HAS_DECODE_RG16
// umbrage_decode_rg16: depth from the two channels of a 16-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
UMBRAGE_HIGHP float umbrage_decode_rg16(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_DEVIATION_RGBA8
#define UMBRAGE_HAS_DECODE_DEVIATION_RGBA8
// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
UMBRAGE_HIGHP vec2 umbrage_decode_deviation_rgba8(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP float mean = umbrage_decode_rg16(vec2(c.x, c.y), 1.0);
    UMBRAGE_HIGHP float deviation = umbrage_decode_rg16(vec2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2(mean, deviation));
}
#endif
