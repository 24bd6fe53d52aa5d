// umbrage 0.1.0, sheared_rotation: rotation of a disc, sheared to an ellipse. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// sheared_rotation, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_sheared_rotation: rotation of a disc, and then a shear along x
//   rotation   from umbrage_disc_rotation
//   shear      by how much x grows with y, both in radii of the ellipse; -2.0 to 2.0
fn umbrage_sheared_rotation(rotation: vec4f, shear: f32) -> vec4f {
    let x: f32 = rotation.x + shear * rotation.z;
    let y: f32 = rotation.y + shear * rotation.w;
    return vec4f(x, y, rotation.z, rotation.w);
}
