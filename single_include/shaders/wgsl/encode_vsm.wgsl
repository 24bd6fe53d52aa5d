// umbrage 0.1.0, encode_vsm: depth to a texel of a variance shadow map (VSM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// encode_vsm, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of vsm: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_vsm of the far plane's
//   depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: cleared_depth.wgsl, saturate.wgsl, to_forward_depth.wgsl; or paste wgsl_joined/encode_vsm.wgsl alone.

// umbrage_encode_vsm: texel of a variance shadow map, depth and its square. NaN counts as far
fn umbrage_encode_vsm(depth: f32) -> vec2f {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(depth));
    return vec2f(d, d * d);
}
