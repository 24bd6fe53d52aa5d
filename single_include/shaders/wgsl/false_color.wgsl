// umbrage 0.1.0, false_color: depth 0..1 as a color from blue over green to red. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// false_color, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
fn umbrage_saturate(v: f32) -> f32 {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return select(select(select(umbrage_cleared_depth(), 0.0, v <= 0.0), 1.0, v >= 1.0), v, v > 0.0 && v < 1.0);
}

// umbrage_false_color: blue for 0.0, through green, to red for 1.0
fn umbrage_false_color(v: f32) -> vec3f {
    let x: f32 = umbrage_saturate(v) * 4.0;
    let ramp: vec3f = 1.5 - abs(vec3f(x - 3.0, x - 2.0, x - 1.0));
    return vec3f(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
