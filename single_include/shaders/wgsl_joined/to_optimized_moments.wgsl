// umbrage 0.1.0, to_optimized_moments: four moments (MSM) to four 16-bit channels. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// to_optimized_moments, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of msm_unorm16: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to
//   umbrage_to_optimized_moments of umbrage_encode_msm of the far plane's depth.

// umbrage_to_optimized_moments: four moments for four 16-bit channels, each over all of 0.0 to 1.0
fn umbrage_to_optimized_moments(b: vec4f) -> vec4f {
    let x: f32 = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    let y: f32 = (b.y - b.w) * 4.0;
    let z: f32 = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    let w: f32 = (b.y + b.w) * 0.5;
    return vec4f(x, y, z, w);
}
