// umbrage 0.1.0, decode_evsm2_hardware: EVSM of two components to visibility, by the GPU's exp2. Exactness: tier C.
// decode_evsm2_hardware, tier C: within 1/64 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CHEBYSHEV_HARDWARE
#define UMBRAGE_HAS_CHEBYSHEV_HARDWARE
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
inline float umbrage_chebyshev_hardware(float variance, float distance, float amount) {
    float beyond = metal::max(distance, 0.0);
    float p = variance / (variance + beyond * beyond);
    return metal::clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
inline float umbrage_to_forward_depth(float depth) {
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
inline float umbrage_decode_evsm2_hardware(float2 m, float receiver, float exponent, float deviation, float amount) {
    float d = umbrage_to_forward_depth(metal::clamp(receiver, 0.0, 1.0));
    float w = metal::exp2(exponent * (d * 2.0 - 1.0));
    float least = deviation * w;
    float variance = metal::max(m.y - m.x * m.x, least * least);
    float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return metal::abs(receiver) < 1048576.0 ? lit : 0.0;
}
#endif
