// umbrage 0.1.0, probe_inputs: debug color, unless position or normal is wrong. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PROBE_INPUTS
#define UMBRAGE_HAS_PROBE_INPUTS
// umbrage_probe_inputs: color, unless the receiver is wrong
//   magenta  position or normal is not a number
//   yellow   a normal of zero
inline float3 umbrage_probe_inputs(float3 color, float3 world, float3 normal) {
    float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = metal::abs(world.x) < limit && metal::abs(world.y) * 2.0 < limit * 2.0 && metal::abs(world.z) *
        4.0 < limit * 4.0;
    usable = usable && metal::abs(normal.x) * 8.0 < limit * 8.0;
    usable = usable && metal::abs(normal.y) * 16.0 < limit * 16.0 && metal::abs(normal.z) * 32.0 < limit * 32.0;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float3 given = zero ? float3(1.0, 1.0, 0.0) : color;
    return usable ? given : float3(1.0, 0.0, 1.0);
}
#endif
