// umbrage 0.1.0, to_optimized_moments: four moments (MSM) to four 16-bit channels. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// to_optimized_moments, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of msm_unorm16: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to
//   umbrage_to_optimized_moments of umbrage_encode_msm of the far plane's depth.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_TO_OPTIMIZED_MOMENTS
#define UMBRAGE_HAS_TO_OPTIMIZED_MOMENTS
// umbrage_to_optimized_moments: four moments for four 16-bit channels, each over all of 0.0 to 1.0
UMBRAGE_HIGHP vec4 umbrage_to_optimized_moments(UMBRAGE_HIGHP vec4 b) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (b.y - b.w) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (b.y + b.w) * 0.5;
    return vec4(x, y, z, w);
}
#endif
