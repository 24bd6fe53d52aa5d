// umbrage 0.1.0, turn_moments: four moments to four channels of 16 bits. Exactness: tier B.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of msm_turned: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to umbrage_turn_moments of
//   umbrage_encode_msm of the far plane's depth.

#ifndef UMBRAGE_HAS_TURN_MOMENTS
#define UMBRAGE_HAS_TURN_MOMENTS
// umbrage_turn_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
float4 umbrage_turn_moments(float4 b) {
    precise float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    precise float y = (b.y - b.w) * 4.0;
    precise float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    precise float w = (b.y + b.w) * 0.5;
    return float4(x, y, z, w);
}
#endif
