// umbrage 0.1.0, moment_atoms: two depths that have the moments with the receiver's. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// moment_atoms, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
fn umbrage_moment_atoms(b: vec4f, x: f32) -> vec4f {
    let d: f32 = b.y - b.x * b.x;
    let third: f32 = b.z - b.x * b.y;
    let l: f32 = third / d;
    let e: f32 = (b.w - b.y * b.y) - third * l;
    let h: f32 = b.x * 2.0 - l;
    let a: f32 = d * ((x + h) * x - d);
    let m: f32 = x * e + h * a;
    let c: f32 = d * (e - a);
    let square: f32 = m * m - 4.0 * a * c;
    let root: f32 = sqrt(select(0.0, square, square > 0.0));
    let w: f32 = select(-(m + root), root - m, m < 0.0) * 0.5;
    let t: vec2f = vec2f(w / a, c / w);
    let q: vec2f = (t + h) * t - d;
    let least: f32 = d * e;
    let sum: vec2f = least + (t * t * e + q * q * d);
    return vec4f(t.x, t.y, least / sum.x, least / sum.y);
}
