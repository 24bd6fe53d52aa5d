// umbrage 0.1.0, map_covers: true if a receiver lies in a prefiltered map. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
inline bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
#endif
