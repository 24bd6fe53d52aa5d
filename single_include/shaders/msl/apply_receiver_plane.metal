// umbrage 0.1.0, apply_receiver_plane: stored depth moved along the receiver's plane to it. Exactness: tier B.
// apply_receiver_plane, tier B: within 8 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_APPLY_RECEIVER_PLANE
#define UMBRAGE_HAS_APPLY_RECEIVER_PLANE
// umbrage_apply_receiver_plane: a texel's depth moved along the receiver's plane to the receiver; not if cleared
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   coord   receiver position, in texels
//   texel   index of the texel
inline float umbrage_apply_receiver_plane(float stored, float2 slope, float2 coord, float2 texel) {
    float2 way = texel + 0.5 - coord;
    float depth = stored - (slope.x * way.x + slope.y * way.y);
    bool cleared = metal::abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return cleared ? stored : depth;
}
#endif
