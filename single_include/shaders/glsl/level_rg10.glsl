// umbrage 0.1.0, MIT License: level_rg10

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

#ifndef UMBRAGE_HAS_LEVEL_RG10
#define UMBRAGE_HAS_LEVEL_RG10
// umbrage_level_rg10: two channels of a 10-bit code, as sampled, to the scale of umbrage_receiver_rg10, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg10(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
#endif
