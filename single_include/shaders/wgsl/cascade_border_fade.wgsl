// umbrage 0.1.0, cascade_border_fade: weight of the next cascade, by distance from the border. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// cascade_border_fade, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}

// umbrage_cascade_border_fade: weight of the next cascade, 1.0 up to reach texels from the border of a map
//   coordinate  position in the map, in texels
//   size        size of the map, in texels
//   per_texel   weight per texel: 1.0 / width of the band along the border
fn umbrage_cascade_border_fade(coordinate: vec2f, size: vec2f, reach: f32, per_texel: f32) -> f32 {
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(coordinate - half_size) - (half_size - reach);
    let v: vec2f = beyond * per_texel + 1.0;
    let x: f32 = umbrage_cascade_weight(v.x);
    let y: f32 = umbrage_cascade_weight(v.y);
    return select(y, x, x > y);
}
