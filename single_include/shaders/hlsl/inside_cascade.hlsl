// umbrage 0.1.0, inside_cascade: true if a filter stays inside a cascade. Exactness: tier B.
// inside_cascade, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_INSIDE_CASCADE
#define UMBRAGE_HAS_INSIDE_CASCADE
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
precise bool umbrage_inside_cascade(float3 coordinate, float2 size, float reach) {
    precise float2 end = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
#endif
