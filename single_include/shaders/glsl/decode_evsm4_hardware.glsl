// umbrage 0.1.0, decode_evsm4_hardware: EVSM of four components to visibility, by the GPU's exp2. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// decode_evsm4_hardware, tier C: within 1/64 of C++.
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

#ifndef UMBRAGE_HAS_DECODE_EVSM4_HARDWARE
#define UMBRAGE_HAS_DECODE_EVSM4_HARDWARE
// umbrage_decode_evsm4_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
//   amount       visibility that becomes 0.0, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm4_hardware(UMBRAGE_HIGHP vec4 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP vec2 exponents, UMBRAGE_HIGHP vec2 deviations,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    UMBRAGE_HIGHP float w = exp2(exponents.x * d);
    UMBRAGE_HIGHP float n = 0.0 - exp2((0.0 - exponents.y) * d);
    UMBRAGE_HIGHP vec2 least = deviations * vec2(w, n);
    UMBRAGE_HIGHP float growing = max(m.y - m.x * m.x, least.x * least.x);
    UMBRAGE_HIGHP float falling = max(m.w - m.z * m.z, least.y * least.y);
    UMBRAGE_HIGHP float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    UMBRAGE_HIGHP float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return abs(receiver) < 1048576.0 ? min(a, b) : 0.0;
}
#endif
