// umbrage 0.1.0, turn_moments_back: four channels of 16 bits to four moments. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_turn_moments_back: four moments of what umbrage_turn_moments made of them
fn umbrage_turn_moments_back(o: vec4f) -> vec4f {
    let x: f32 = o.x - 0.5;
    let z: f32 = o.z - 0.5;
    let eighth: f32 = o.y * 0.125;
    let b1: f32 = z * 1.73205078 - x * 0.333333343;
    let b2: f32 = o.w + eighth;
    let b3: f32 = z * 1.29903817 - x * 0.75;
    let b4: f32 = o.w - eighth;
    return vec4f(b1, b2, b3, b4);
}
