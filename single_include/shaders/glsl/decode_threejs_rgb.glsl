// umbrage 0.1.0, decode_threejs_rgb: three.js RGB, r167 and later, to depth. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// decode_threejs_rgb, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_rgb: RGB8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255) / 255, with
//   reversed depth to (0, 0, 0) / 255. Write umbrage_write_threejs_rgb.

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

#ifndef UMBRAGE_HAS_DECODE_THREEJS_RGB
#define UMBRAGE_HAS_DECODE_THREEJS_RGB
// umbrage_decode_threejs_rgb: depth from the RGB format of three.js r167 and later, as sampled
UMBRAGE_HIGHP float umbrage_decode_threejs_rgb(UMBRAGE_HIGHP vec3 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
#endif
