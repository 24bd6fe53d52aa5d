// umbrage 0.1.0, cascade_tile: first texel of a cascade in an atlas. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_tile: first texel of a cascade, 0.0 to 3.0, in an atlas of 2 x 2 tiles of size texels
fn umbrage_cascade_tile(number: f32, size: f32) -> vec2f {
    let row: f32 = select(1.0, 0.0, number < 1.5);
    return vec2f((number - row * 2.0) * size, row * size);
}
