// umbrage 0.1.0, hardened_kernel8: fraction of a disc in shadow, steepened. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_HARDENED_KERNEL8
#define UMBRAGE_HAS_HARDENED_KERNEL8
// umbrage_hardened_kernel8: fraction of 8 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
inline float umbrage_hardened_kernel8(float blocked, float ratio) {
    float u = blocked * 2.0 - 8.0;
    float d = metal::max(8.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 512.0 - d * d * d;
    float hard = u < 0.0 ? 512.0 - steep : 512.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
#endif
