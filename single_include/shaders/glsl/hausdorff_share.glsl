// umbrage 0.1.0, hausdorff_share: smallest fraction of nearer depths, for depths on [-1, 1]. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// hausdorff_share, tier C: within 1/1048576 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
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

#ifndef UMBRAGE_HAS_HAUSDORFF_SHARE
#define UMBRAGE_HAS_HAUSDORFF_SHARE
// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
UMBRAGE_HIGHP float umbrage_hausdorff_share(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float z) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float variance = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float fourth = b.w - b.y * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float rest = 1.0 - b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = z - b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = third + rest * x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float g = (fourth - variance * rest) - (z + b.x) * third;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = d * (1.0 + b.x) + g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float q = d * (1.0 - b.x) - g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float k = rest * g + third * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    UMBRAGE_HIGHP float square = d * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float between = p * (q * (x * d - g));
    UMBRAGE_HIGHP float end = first / (2.0 * ((1.0 + z) * p));
    UMBRAGE_HIGHP float other = square * square / between;
    UMBRAGE_HIGHP float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
#endif
