// umbrage 0.1.0, decode_vsm_hardware: mean and deviation (VSM) to visibility, cheapest on GPUs. Exactness: tier C.
// decode_vsm_hardware, tier C: within 1/1024 of C++.
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

#ifndef UMBRAGE_HAS_DECODE_VSM_HARDWARE
#define UMBRAGE_HAS_DECODE_VSM_HARDWARE
// umbrage_decode_vsm_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   held           mean and twice the standard deviation of depths, filtered
//   receiver       receiver depth, bias applied
//   min_variance   1e-7 or more
//   amount         visibility that becomes 0.0, 0.0 to 0.5
inline float umbrage_decode_vsm_hardware(float2 held, float receiver, float min_variance, float amount) {
    float variance = metal::max(held.y * held.y * 0.25, min_variance);
    float distance = umbrage_to_forward_depth(receiver) - held.x;
    float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return metal::abs(receiver) < 1048576.0 ? lit : 0.0;
}
#endif
