// umbrage 0.1.0, hausdorff_share: smallest fraction of nearer depths, for depths on [-1, 1]. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// hausdorff_share, tier C: within 1/1048576 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
fn umbrage_hausdorff_share(b: vec4f, z: f32) -> f32 {
    let variance: f32 = b.y - b.x * b.x;
    let third: f32 = b.z - b.x * b.y;
    let fourth: f32 = b.w - b.y * b.y;
    let rest: f32 = 1.0 - b.y;
    let x: f32 = z - b.x;
    let d: f32 = third + rest * x;
    let g: f32 = (fourth - variance * rest) - (z + b.x) * third;
    let p: f32 = d * (1.0 + b.x) + g;
    let q: f32 = d * (1.0 - b.x) - g;
    let k: f32 = rest * g + third * d;
    let first: f32 = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    let last: f32 = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    let square: f32 = d * d;
    let between: f32 = p * (q * (x * d - g));
    let end: f32 = first / (2.0 * ((1.0 + z) * p));
    let other: f32 = square * square / between;
    let share: f32 = end + select(0.0, other, d > 0.0);
    let four: bool = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return select(select(-1.0, select(1.0, share, share < 1.0), four), 0.0, z <= -1.0);
}
