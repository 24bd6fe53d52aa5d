// umbrage 0.1.0, is_compared: receivers that a filter compares; it takes the others as lit. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl; or paste wgsl_joined/is_compared.wgsl alone.

// umbrage_is_compared: whether a filter compares a receiver; outside texel space and beyond the far plane all is lit
fn umbrage_is_compared(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far(receiver));
}
