// umbrage 0.1.0, cube_tile: first texel of a face in an atlas. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CUBE_TILE
#define UMBRAGE_HAS_CUBE_TILE
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
inline float2 umbrage_cube_tile(float face, float size) {
    float row = face < 2.5 ? 0.0 : 1.0;
    return float2((face - row * 3.0) * size, row * size);
}
#endif
