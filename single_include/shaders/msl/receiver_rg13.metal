// umbrage 0.1.0, receiver_rg13: receiver to a level, for maps that are not decoded. Exactness: tier B.
// receiver_rg13, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_RECEIVER_RG13
#define UMBRAGE_HAS_RECEIVER_RG13
// umbrage_receiver_rg13: receiver depth on the scale of umbrage_level_rg13. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg13(float depth, float edge) {
    float level = (metal::ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif
