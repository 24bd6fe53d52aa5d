// umbrage 0.1.0, decode_fixed_ps14: r / 8 + g in the Radeon 8500's fixed point. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: fixed_ps14.wgsl; or paste wgsl_joined/decode_fixed_ps14.wgsl alone.

// umbrage_decode_fixed_ps14: x / 2040 in steps of 1 / 4096 from the channels of an 11-bit code, as sampled
//   compare with umbrage_fixed_ps14(umbrage_receiver_ps14(depth)); 1.0 is not the far plane on this scale
fn umbrage_decode_fixed_ps14(c: vec2f) -> f32 {
    return floor(umbrage_fixed_ps14(c.x) * 512.0) * 0.000244140625 + umbrage_fixed_ps14(c.y);
}
