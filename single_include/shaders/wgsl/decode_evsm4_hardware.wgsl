// umbrage 0.1.0, decode_evsm4_hardware: EVSM of four components to visibility, by the GPU's exp2. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_evsm4_hardware, tier C: within 1/64 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
fn umbrage_chebyshev_hardware(variance: f32, distance: f32, amount: f32) -> f32 {
    let beyond: f32 = max(distance, 0.0);
    let p: f32 = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}

// umbrage_decode_evsm4_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
//   amount       visibility that becomes 0.0, 0.0 to 0.3
fn umbrage_decode_evsm4_hardware(m: vec4f, receiver: f32, exponents: vec2f, deviations: vec2f, amount: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    let w: f32 = exp2(exponents.x * d);
    let n: f32 = 0.0 - exp2((0.0 - exponents.y) * d);
    let least: vec2f = deviations * vec2f(w, n);
    let growing: f32 = max(m.y - m.x * m.x, least.x * least.x);
    let falling: f32 = max(m.w - m.z * m.z, least.y * least.y);
    let a: f32 = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    let b: f32 = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return select(0.0, min(a, b), abs(receiver) < 1048576.0);
}
