// umbrage 0.1.0, tetrahedron_texel: position in the map of a point on a tetrahedron's face. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// tetrahedron_texel, tier B: within 9 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
fn umbrage_tetrahedron_turned(face: f32, v: vec2f) -> vec2f {
    let z: vec2f = select(vec2f(-v.x, -v.y), v, face < 0.5);
    let x: vec2f = select(vec2f(v.y, -v.x), vec2f(-v.y, v.x), face < 2.5);
    return select(x, z, face < 1.5);
}

// umbrage_tetrahedron_texel: position in a square map, in texels, from (s, t, face) on a tetrahedron
//   size    size of the map, in texels
//   border  border along the sides of each triangle, in texels
fn umbrage_tetrahedron_texel(at: vec3f, size: f32, border: f32) -> vec2f {
    let half_size: f32 = size * 0.5;
    let scale: f32 = half_size - border * 3.0;
    let x: f32 = at.x * scale;
    let y: f32 = at.y * scale + (border - half_size);
    let texel: vec2f = umbrage_tetrahedron_turned(at.z, vec2f(x, y)) + half_size;
    return texel;
}
