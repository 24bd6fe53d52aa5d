// umbrage 0.1.0, cascade_tile: first texel of a cascade in an atlas. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CASCADE_TILE
#define UMBRAGE_HAS_CASCADE_TILE
// umbrage_cascade_tile: first texel of a cascade, 0.0 to 3.0, in an atlas of 2 x 2 tiles of size texels
inline float2 umbrage_cascade_tile(float number, float size) {
    float row = number < 1.5 ? 0.0 : 1.0;
    return float2((number - row * 2.0) * size, row * size);
}
#endif
