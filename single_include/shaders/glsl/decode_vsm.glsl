// umbrage 0.1.0, decode_vsm: mean of VSM texels to visibility. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// decode_vsm, tier C: within 13 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

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

#ifndef UMBRAGE_HAS_CHEBYSHEV
#define UMBRAGE_HAS_CHEBYSHEV
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
UMBRAGE_HIGHP float umbrage_chebyshev(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                      UMBRAGE_HIGHP float min_variance) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float difference = m.y - m.x * m.x;
    UMBRAGE_HIGHP float variance = difference > min_variance ? difference : min_variance;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float distance = receiver - m.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = variance + distance * distance;
    UMBRAGE_HIGHP float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
UMBRAGE_HIGHP float umbrage_to_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_VSM
#define UMBRAGE_HAS_DECODE_VSM
// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
UMBRAGE_HIGHP float umbrage_decode_vsm(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
#endif
