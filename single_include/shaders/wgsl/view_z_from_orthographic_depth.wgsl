// umbrage 0.1.0, view_z_from_orthographic_depth: orthographic depth to view-space z. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_view_z_from_orthographic_depth: orthographic depth in [0, 1], 0.0 at z_near, to distance along the light's
// axis; when reversed, exchange z_near and z_far
fn umbrage_view_z_from_orthographic_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    let z_view: f32 = z_near + depth * (z_far - z_near);
    return z_view;
}
