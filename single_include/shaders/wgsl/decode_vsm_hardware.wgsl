// umbrage 0.1.0, decode_vsm_hardware: mean and deviation (VSM) to visibility, cheapest on GPUs. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_vsm_hardware, tier C: within 1/1024 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: chebyshev_hardware.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl; or paste
//   wgsl_joined/decode_vsm_hardware.wgsl alone.

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
