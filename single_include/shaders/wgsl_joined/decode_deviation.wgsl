// umbrage 0.1.0, decode_deviation: mean and deviation to two moments of depth (VSM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// decode_deviation, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
fn umbrage_decode_deviation(held: vec2f) -> vec2f {
    let half_of_it: f32 = held.y * 0.5;
    let square: f32 = held.x * held.x + half_of_it * half_of_it;
    return vec2f(held.x, square);
}
