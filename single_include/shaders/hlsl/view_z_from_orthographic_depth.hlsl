// umbrage 0.1.0, view_z_from_orthographic_depth: orthographic depth to view-space z. Exactness: tier B.
// view_z_from_orthographic_depth, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_VIEW_Z_FROM_ORTHOGRAPHIC_DEPTH
#define UMBRAGE_HAS_VIEW_Z_FROM_ORTHOGRAPHIC_DEPTH
// umbrage_view_z_from_orthographic_depth: distance along the light's axis from orthographic depth in [0, 1]
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
float umbrage_view_z_from_orthographic_depth(float depth, float z_near, float z_far) {
    precise float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
#endif
