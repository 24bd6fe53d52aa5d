// umbrage 0.1.0, penumbra: radius of a penumbra from the distance to the blocker. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PENUMBRA
#define UMBRAGE_HAS_PENUMBRA
// umbrage_penumbra: radius of a penumbra in 1/16 texel, an integer
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code, min_radius, max_radius), from make_penumbra_params
inline float umbrage_penumbra(float apart, float3 softness) {
    return metal::min(metal::max(metal::floor(apart * softness.x), softness.y), softness.z);
}
#endif
