// umbrage 0.1.0, cube_atlas_texel: face of an atlas texel, and the position on it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
fn umbrage_cube_atlas_texel(texel: vec2f, size: f32) -> vec3f {
    let column: f32 = select(select(2.0, 1.0, texel.x < size * 2.0), 0.0, texel.x < size);
    let row: f32 = select(1.0, 0.0, texel.y < size);
    return vec3f(texel - vec2f(column, row) * size, column + row * 3.0);
}
