// umbrage 0.1.0, cascade_by_depth: cascade that contains a view depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CASCADE_BY_DEPTH
#define UMBRAGE_HAS_CASCADE_BY_DEPTH
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
inline float umbrage_cascade_by_depth(float depth, float3 ends) {
    int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
#endif
