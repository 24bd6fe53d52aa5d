// umbrage 0.1.0, from_optimized_moments: four 16-bit channels to four moments (MSM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// from_optimized_moments, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
fn umbrage_from_optimized_moments(o: vec4f) -> vec4f {
    let x: f32 = o.x - 0.5;
    let z: f32 = o.z - 0.5;
    let eighth: f32 = o.y * 0.125;
    let b1: f32 = z * 1.73205078 - x * 0.333333343;
    let b2: f32 = o.w + eighth;
    let b3: f32 = z * 1.29903817 - x * 0.75;
    let b4: f32 = o.w - eighth;
    return vec4f(b1, b2, b3, b4);
}
