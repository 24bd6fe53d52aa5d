// umbrage 0.1.0, level_rg12: two channels to a level, for maps that are not decoded. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// level_rg12, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_level_rg12: level of a texel from two channels of a 12-bit code, on the scale of umbrage_receiver_rg12
//   1.0 is not the far plane on this scale
fn umbrage_level_rg12(c: vec2f) -> f32 {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
