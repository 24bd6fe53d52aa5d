// umbrage 0.1.0, fixed_ps14: number in a register of the Radeon 8500. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_FIXED_PS14
#define UMBRAGE_HAS_FIXED_PS14
// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
inline float umbrage_fixed_ps14(float v) {
    // not v < 8.0 ? v : ...: Mesa turns it into min, and softpipe's min gives NaN
    float within = v > -8.0 && v < 7.999755859375 ? v : (v < 0.0 ? -8.0 : 7.999755859375);
    float steps = within * 4096.0;
    float below = metal::floor(steps);
    return (steps - below < 0.5 ? below : below + 1.0) * 0.000244140625;
}
#endif
