// umbrage 0.1.0, decode_base255: base-255 RGBA to depth. Exactness: tier B.
// decode_base255, tier B: within 6 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of base255: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_base255.
// Render target of base255_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_base255_repaired.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DECODE_BASE255
#define UMBRAGE_HAS_DECODE_BASE255
// umbrage_decode_base255: depth from base-255 RGBA, as sampled
inline float umbrage_decode_base255(float4 c) {
    float depth = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
#endif
