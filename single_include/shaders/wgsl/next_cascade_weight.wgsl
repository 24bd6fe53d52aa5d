// umbrage 0.1.0, next_cascade_weight: weight of the next cascade, by both edges. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// next_cascade_weight, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}

// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
fn umbrage_next_cascade_weight(found: vec3f, blending: vec4f) -> f32 {
    let v: vec2f = vec2f(found.y, found.z) * blending.x + 1.0;
    let leaves: f32 = umbrage_cascade_weight(v.x);
    let held: f32 = select(0.0, 1.0 - umbrage_cascade_weight(v.y), found.z <= 0.0);
    let weight: f32 = select(min(leaves, held), leaves, found.x >= blending.y);
    return select(0.0, weight, blending.x > 0.0 && found.x <= blending.y);
}
