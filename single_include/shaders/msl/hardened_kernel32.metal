// umbrage 0.1.0, hardened_kernel32: fraction of a disc in shadow, steepened. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_HARDENED_KERNEL32
#define UMBRAGE_HAS_HARDENED_KERNEL32
// umbrage_hardened_kernel32: fraction of 32 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
inline float umbrage_hardened_kernel32(float blocked, float ratio) {
    float u = blocked * 2.0 - 32.0;
    float d = metal::max(32.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 32768.0 - d * d * d;
    float hard = u < 0.0 ? 32768.0 - steep : 32768.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
#endif
