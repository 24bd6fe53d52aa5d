// umbrage 0.1.0, decode_deviation: mean and deviation to depth's two moments. Exactness: tier B.
// Tier B: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
fn umbrage_decode_deviation(held: vec2f) -> vec2f {
    let half_of_it: f32 = held.y * 0.5;
    let square: f32 = held.x * held.x + half_of_it * half_of_it;
    return vec2f(held.x, square);
}
