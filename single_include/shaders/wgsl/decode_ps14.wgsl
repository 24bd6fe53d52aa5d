// umbrage 0.1.0, decode_ps14: r / 8 + g as the Radeon 8500 computed it. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// decode_ps14, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_decode_ps14: x / 2040 from the channels of an 11-bit code, as sampled. Compare with umbrage_receiver_ps14
//   1.0 is not the far plane on this scale
fn umbrage_decode_ps14(c: vec2f) -> f32 {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
