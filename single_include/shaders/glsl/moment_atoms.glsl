// umbrage 0.1.0, moment_atoms: two depths that have the moments with the receiver's. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// moment_atoms, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
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

#ifndef UMBRAGE_HAS_MOMENT_ATOMS
#define UMBRAGE_HAS_MOMENT_ATOMS
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
UMBRAGE_HIGHP vec4 umbrage_moment_atoms(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float x) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_HIGHP float l = third / d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float e = (b.w - b.y * b.y) - third * l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float h = b.x * 2.0 - l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float a = d * ((x + h) * x - d);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float m = x * e + h * a;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float c = d * (e - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = m * m - 4.0 * a * c;
    UMBRAGE_HIGHP float root = sqrt(square > 0.0 ? square : 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    UMBRAGE_HIGHP vec2 t = vec2(w / a, c / w);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 q = (t + h) * t - d;
    UMBRAGE_HIGHP float least = d * e;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 sum = least + (t * t * e + q * q * d);
    return vec4(t.x, t.y, least / sum.x, least / sum.y);
}
#endif
