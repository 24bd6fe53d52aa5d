// umbrage 0.1.0, tetrahedron_turned: vector rotated from face 0's part of the map to another's. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
fn umbrage_tetrahedron_turned(face: f32, v: vec2f) -> vec2f {
    let z: vec2f = select(vec2f(-v.x, -v.y), v, face < 0.5);
    let x: vec2f = select(vec2f(v.y, -v.x), vec2f(-v.y, v.x), face < 2.5);
    return select(x, z, face < 1.5);
}
