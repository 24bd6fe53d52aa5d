// umbrage 0.1.0, cube_tile: first texel of a face in an atlas. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
fn umbrage_cube_tile(face: f32, size: f32) -> vec2f {
    let row: f32 = select(1.0, 0.0, face < 2.5);
    return vec2f((face - row * 3.0) * size, row * size);
}
