// umbrage 0.1.0, encode_evsm2: depth to an EVSM texel of two components. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// encode_evsm2, tier B: within 73 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of evsm2: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_evsm2 of the far plane's
//   depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: cleared_depth.wgsl, saturate.wgsl, to_forward_depth.wgsl, power_of_two.wgsl, exp2_polynomial.wgsl,
//   exponential_warp.wgsl; or paste wgsl_joined/encode_evsm2.wgsl alone.

// umbrage_encode_evsm2: texel of two components, a power of depth and its square. NaN counts as far
fn umbrage_encode_evsm2(depth: f32, exponent: f32) -> vec2f {
    let w: f32 = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return vec2f(w, w * w);
}
