// umbrage 0.1.0, orthographic_depth_from_view_z: view-space z to orthographic depth. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// orthographic_depth_from_view_z, tier C: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_orthographic_depth_from_view_z: orthographic depth in [0, 1] from the distance along the light's axis
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
fn umbrage_orthographic_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return (z_view - z_near) / (z_far - z_near);
}
