// umbrage 0.1.0, bias_moments: four moments, moved a little towards those of spread depths. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
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
