// umbrage 0.1.0, decode_vsm_hardware: mean and deviation (VSM) to visibility, cheapest on GPUs. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_vsm_hardware, tier C: within 1/1024 of C++.
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

// umbrage_decode_vsm_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   held           mean and twice the standard deviation of depths, filtered
//   receiver       receiver depth, bias applied
//   min_variance   1e-7 or more
//   amount         visibility that becomes 0.0, 0.0 to 0.5
fn umbrage_decode_vsm_hardware(held: vec2f, receiver: f32, min_variance: f32, amount: f32) -> f32 {
    let variance: f32 = max(held.y * held.y * 0.25, min_variance);
    let distance: f32 = umbrage_to_forward_depth(receiver) - held.x;
    let lit: f32 = umbrage_chebyshev_hardware(variance, distance, amount);
    return select(0.0, lit, abs(receiver) < 1048576.0);
}
