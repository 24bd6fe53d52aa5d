// umbrage 0.1.0, turn_moments: four moments to four channels of 16 bits. Exactness: tier B.
// Tier B: GLSL below 400 and 320 es lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of msm_turned: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to umbrage_turn_moments of
//   umbrage_encode_msm of the far plane's depth.

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

#ifndef UMBRAGE_HAS_TURN_MOMENTS
#define UMBRAGE_HAS_TURN_MOMENTS
// umbrage_turn_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
UMBRAGE_HIGHP vec4 umbrage_turn_moments(UMBRAGE_HIGHP vec4 b) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (b.y - b.w) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (b.y + b.w) * 0.5;
    return vec4(x, y, z, w);
}
#endif
