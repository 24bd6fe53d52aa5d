// umbrage 0.1.0, turn_moments: four moments to four channels of 16 bits. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of msm_turned: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to umbrage_turn_moments of
//   umbrage_encode_msm of the far plane's depth.

// umbrage_turn_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
fn umbrage_turn_moments(b: vec4f) -> vec4f {
    let x: f32 = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    let y: f32 = (b.y - b.w) * 4.0;
    let z: f32 = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    let w: f32 = (b.y + b.w) * 0.5;
    return vec4f(x, y, z, w);
}
