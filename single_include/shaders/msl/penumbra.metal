// umbrage 0.1.0, penumbra: radius of a penumbra from the distance between blocker and receiver. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PENUMBRA
#define UMBRAGE_HAS_PENUMBRA
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
inline float umbrage_penumbra(float apart, float3 softness) {
    return metal::min(metal::max(metal::floor(apart * softness.x), softness.y), softness.z);
}
#endif
