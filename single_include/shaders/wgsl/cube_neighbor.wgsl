// umbrage 0.1.0, cube_neighbor: texel beyond an edge of a cube's face. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cube_face.wgsl, cube_plane.wgsl, cube_point.wgsl; or paste wgsl_joined/cube_neighbor.wgsl alone.

// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
fn umbrage_cube_neighbor(texel: vec3f, size: f32) -> vec3f {
    let uv: vec2f = vec2f(texel.x, texel.y) * 2.0 + (1.0 - size);
    let beyond_u: bool = abs(uv.x) > size;
    let beyond_v: bool = abs(uv.y) > size;
    let m: f32 = select(size, size - 1.0, beyond_u || beyond_v);
    let p: vec3f = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3f(uv, m)));
    let inside: vec2f = (vec2f(p.x, p.y) + (size - 1.0)) * 0.5;
    return select(vec3f(inside, p.z), vec3f(0.0, 0.0, -1.0), beyond_u && beyond_v);
}
