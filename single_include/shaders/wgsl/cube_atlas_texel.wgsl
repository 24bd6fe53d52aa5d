// umbrage 0.1.0, cube_atlas_texel: face that a texel of an atlas belongs to, and where on it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_atlas_texel: (s, t, face) of a texel of an atlas of 3 x 2 tiles of size texels; whole numbers
fn umbrage_cube_atlas_texel(texel: vec2f, size: f32) -> vec3f {
    let column: f32 = select(select(2.0, 1.0, texel.x < size * 2.0), 0.0, texel.x < size);
    let row: f32 = select(1.0, 0.0, texel.y < size);
    return vec3f(texel - vec2f(column, row) * size, column + row * 3.0);
}
