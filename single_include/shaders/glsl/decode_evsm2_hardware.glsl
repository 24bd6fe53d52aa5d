// umbrage 0.1.0, decode_evsm2_hardware: EVSM of two components to visibility, by the GPU's exp2. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// decode_evsm2_hardware, tier C: within 1/64 of C++.
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

#ifndef UMBRAGE_HAS_CHEBYSHEV_HARDWARE
#define UMBRAGE_HAS_CHEBYSHEV_HARDWARE
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_chebyshev_hardware(UMBRAGE_HIGHP float variance, UMBRAGE_HIGHP float distance,
                                               UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float beyond = max(distance, 0.0);
    UMBRAGE_HIGHP float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
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

#ifndef UMBRAGE_HAS_DECODE_EVSM2_HARDWARE
#define UMBRAGE_HAS_DECODE_EVSM2_HARDWARE
// umbrage_decode_evsm2_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
//   amount      visibility that becomes 0.0, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm2_hardware(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP float exponent, UMBRAGE_HIGHP float deviation,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0));
    UMBRAGE_HIGHP float w = exp2(exponent * (d * 2.0 - 1.0));
    UMBRAGE_HIGHP float least = deviation * w;
    UMBRAGE_HIGHP float variance = max(m.y - m.x * m.x, least * least);
    UMBRAGE_HIGHP float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
#endif
