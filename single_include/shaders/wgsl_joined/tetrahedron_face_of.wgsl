// umbrage 0.1.0, tetrahedron_face_of: face of a tetrahedron that contains a texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tetrahedron_face_of: face, 0.0 to 3.0, whose triangle contains a texel, in a map of size texels
fn umbrage_tetrahedron_face_of(texel: vec2f, size: f32) -> f32 {
    let off: vec2f = texel * 2.0 + (1.0 - size);
    let column: f32 = select(1.0, 0.0, off.y < 0.0);
    let row: f32 = select(2.0, 3.0, off.x < 0.0);
    return select(row, column, abs(off.y) >= abs(off.x));
}
