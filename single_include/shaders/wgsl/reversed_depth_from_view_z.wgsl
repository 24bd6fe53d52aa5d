// umbrage 0.1.0, reversed_depth_from_view_z: view-space z to reversed perspective depth. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// reversed_depth_from_view_z, tier C: within 13 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_reversed_depth_from_view_z: perspective depth in [0, 1], 1.0 at z_near, from the distance along the light's
// axis
fn umbrage_reversed_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
