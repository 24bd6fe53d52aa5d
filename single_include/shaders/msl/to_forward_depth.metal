// umbrage 0.1.0, to_forward_depth: depth that grows with the distance from the light. Exactness: tier B.
// to_forward_depth, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
inline float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif
