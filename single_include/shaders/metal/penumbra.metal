// umbrage 0.1.0, MIT License: penumbra

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PENUMBRA
#define UMBRAGE_HAS_PENUMBRA
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, least, widest), of make_softness
inline float umbrage_penumbra(float apart, float3 softness) {
    return metal::min(metal::max(metal::floor(apart * softness.x), softness.y), softness.z);
}
#endif
