// umbrage 0.1.0, inside_map: true if a texel lies inside the map. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_INSIDE_MAP
#define UMBRAGE_HAS_INSIDE_MAP
// umbrage_inside_map: true if a texel lies inside a map of size texels
inline bool umbrage_inside_map(float2 size, float2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
#endif
