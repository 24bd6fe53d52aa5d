// umbrage 0.1.0, box_scale: 1 / (2r+1)^2. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_BOX_SCALE
#define UMBRAGE_HAS_BOX_SCALE
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
inline float umbrage_box_scale(int radius) {
    float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
#endif
