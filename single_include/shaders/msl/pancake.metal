// umbrage 0.1.0, pancake: casters clamped to the near plane (pancaking). Exactness: tier B.
// pancake, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PANCAKE
#define UMBRAGE_HAS_PANCAKE
// umbrage_pancake: clip space position, clamped to the near plane if it lies in front of it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
inline float4 umbrage_pancake(float4 position, float at_near) {
    float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return float4(position.x, position.y, before ? plane : position.z, position.w);
}
#endif
