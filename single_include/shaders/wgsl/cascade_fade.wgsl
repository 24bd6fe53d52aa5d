// umbrage 0.1.0, cascade_fade: weight of the next cascade, by view depth. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// cascade_fade, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}

// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
fn umbrage_cascade_fade(depth: f32, scale: f32, offset: f32) -> f32 {
    let v: f32 = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
