// umbrage 0.1.0, MIT License: decode_ps14

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

// depths here are on a scale of their own, on which 1.0 is not the far plane
#ifndef UMBRAGE_BEYOND_FAR
#define UMBRAGE_BEYOND_FAR(receiver) false
#endif

#ifndef UMBRAGE_HAS_DECODE_PS14
#define UMBRAGE_HAS_DECODE_PS14
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14;
//   1.0 is not the far plane on this scale
UMBRAGE_HIGHP float umbrage_decode_ps14(UMBRAGE_HIGHP vec2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
#endif
