// umbrage 0.1.0, bleed_cut: visibility without its least values. Exactness: tier C.
// Tier C: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_bleed_cut: visibility from amount to 1.0 stretched to 0.0 to 1.0, so that less light bleeds through
fn umbrage_bleed_cut(visibility: f32, amount: f32) -> f32 {
    let stretched: f32 = (visibility - amount) / (1.0 - amount);
    return select(0.0, stretched, visibility > amount);
}
