// umbrage 0.1.0, tetrahedron_shape: shape of penumbras at a texel of a tetrahedron's map. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_tetrahedron_shape: shape of penumbras at a texel of a tetrahedron's map
//   center   x: half the map's size in texels
//   number   not read
//   at       place in the map, texels
//   returns factors of face 0's softness in x and y, and no shear
fn umbrage_tetrahedron_shape(center: vec4f, number: f32, at: vec2f) -> vec3f {
    let beside: bool = abs(at.x - center.x) > abs(at.y - center.x);
    return select(vec3f(1.0, 1.0, 0.0), vec3f(0.577350269, 1.73205081, 0.0), beside);
}
