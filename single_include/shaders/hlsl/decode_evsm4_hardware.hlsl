// umbrage 0.1.0, decode_evsm4_hardware: EVSM of four components to visibility, by the GPU's exp2. Exactness: tier C.
// decode_evsm4_hardware, tier C: within 1/64 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_CHEBYSHEV_HARDWARE
#define UMBRAGE_HAS_CHEBYSHEV_HARDWARE
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
float umbrage_chebyshev_hardware(float variance, float distance, float amount) {
    float beyond = max(distance, 0.0);
    float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
float umbrage_to_forward_depth(float depth) {
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
float umbrage_decode_evsm4_hardware(float4 m, float receiver, float2 exponents, float2 deviations, float amount) {
    float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    float w = exp2(exponents.x * d);
    float n = 0.0 - exp2((0.0 - exponents.y) * d);
    float2 least = deviations * float2(w, n);
    float growing = max(m.y - m.x * m.x, least.x * least.x);
    float falling = max(m.w - m.z * m.z, least.y * least.y);
    float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return abs(receiver) < 1048576.0 ? min(a, b) : 0.0;
}
#endif
