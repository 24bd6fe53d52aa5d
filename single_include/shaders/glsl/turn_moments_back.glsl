// umbrage 0.1.0, turn_moments_back: four channels of 16 bits to four moments. Exactness: tier B.
// Tier B: GLSL below 400 and 320 es lets compilers fuse or reorder sums. Results then stay within the stated bound.
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

#ifndef UMBRAGE_HAS_TURN_MOMENTS_BACK
#define UMBRAGE_HAS_TURN_MOMENTS_BACK
// umbrage_turn_moments_back: four moments of what umbrage_turn_moments made of them
UMBRAGE_HIGHP vec4 umbrage_turn_moments_back(UMBRAGE_HIGHP vec4 o) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = o.x - 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = o.z - 0.5;
    UMBRAGE_HIGHP float eighth = o.y * 0.125;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b1 = z * 1.73205078 - x * 0.333333343;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b2 = o.w + eighth;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b3 = z * 1.29903817 - x * 0.75;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b4 = o.w - eighth;
    return vec4(b1, b2, b3, b4);
}
#endif
