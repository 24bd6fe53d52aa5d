// umbrage 0.1.0, linear_depth: view-space z over z_far. Exactness: tier B.
// linear_depth, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_LINEAR_DEPTH
#define UMBRAGE_HAS_LINEAR_DEPTH
// umbrage_linear_depth: distance along the light's axis, positive in front of the light, times 1 / z_far
float umbrage_linear_depth(float z_view, float inv_z_far) {
    return z_view * inv_z_far;
}
#endif
