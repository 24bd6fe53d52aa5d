// umbrage 0.1.0, view_z_from_orthographic_depth: orthographic depth to view-space z. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// view_z_from_orthographic_depth, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_view_z_from_orthographic_depth: distance along the light's axis from orthographic depth in [0, 1]
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
fn umbrage_view_z_from_orthographic_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    let z_view: f32 = z_near + depth * (z_far - z_near);
    return z_view;
}
