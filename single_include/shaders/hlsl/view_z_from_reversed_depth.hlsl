// umbrage 0.1.0, view_z_from_reversed_depth: reversed perspective depth to view-space z. Exactness: tier C.
// view_z_from_reversed_depth, tier C: within 11 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_VIEW_Z_FROM_REVERSED_DEPTH
#define UMBRAGE_HAS_VIEW_Z_FROM_REVERSED_DEPTH
// umbrage_view_z_from_reversed_depth: distance along the light's axis from perspective depth in [0, 1], 1.0 at z_near
float umbrage_view_z_from_reversed_depth(float depth, float z_near, float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
#endif
