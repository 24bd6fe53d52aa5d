// umbrage 0.1.0, bias_moments: four moments (MSM) with a bias against rounding. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// bias_moments, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
fn umbrage_bias_moments(b: vec4f, bias: vec2f) -> vec4f {
    let x: f32 = b.x - b.x * bias.x;
    let y: f32 = b.y + (bias.y - b.y) * bias.x;
    let z: f32 = b.z - b.z * bias.x;
    let w: f32 = b.w + (bias.y - b.w) * bias.x;
    return vec4f(x, y, z, w);
}
