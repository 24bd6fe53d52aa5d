// umbrage 0.1.0, MIT License: decode_threejs_rg

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

#ifndef UMBRAGE_HAS_DECODE_THREEJS_RG
#define UMBRAGE_HAS_DECODE_THREEJS_RG
// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_rg(UMBRAGE_HIGHP vec2 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
#endif
