// umbrage 0.1.0, pcss_radius: penumbra radius from the mean depth of blockers. Exactness: tier C.
// pcss_radius, tier C: within 1/1024 of C++.
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

#ifndef UMBRAGE_HAS_PCSS_RADIUS
#define UMBRAGE_HAS_PCSS_RADIUS
// umbrage_pcss_radius: radius of a penumbra in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code, min_radius, max_radius), from make_penumbra_params
inline float umbrage_pcss_radius(float2 found, float receiver, float3 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    float radius = (forward ? receiver - mean : mean - receiver) * (softness.x * 4096.0);
    float min_radius = softness.y * 0.0625;
    return radius > min_radius ? metal::min(radius, softness.z * 0.0625) : min_radius;
}
#endif
