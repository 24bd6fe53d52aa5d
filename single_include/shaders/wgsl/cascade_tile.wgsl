// umbrage 0.1.0, cascade_tile: first texel of a cascade in an atlas. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_tile: first texel of a cascade in an atlas with two tiles of size texels per row
fn umbrage_cascade_tile(number: f32, size: vec2f) -> vec2f {
    let row: f32 = floor(number * 0.5);
    return vec2f(number - row * 2.0, row) * size;
}
