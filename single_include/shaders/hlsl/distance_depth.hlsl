// umbrage 0.1.0, distance_depth: distance to the light over its range. Exactness: tier C.
// distance_depth, tier C: within 9 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_DISTANCE_DEPTH
#define UMBRAGE_HAS_DISTANCE_DEPTH
// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
float umbrage_distance_depth(float3 to_point, float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
#endif
