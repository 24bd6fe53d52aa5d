// umbrage 0.1.0, box: lit fraction of a box of radius 0..8 (box PCF). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// box, tier B: within 290 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: box_shadow.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
fn umbrage_box_scale(radius: i32) -> f32 {
    var scale: f32 = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) { scale = 0.00444444455; }
    if (radius < 7) { scale = 0.00591715984; }
    if (radius < 6) { scale = 0.00826446246; }
    if (radius < 5) { scale = 0.0123456791; }
    if (radius < 4) { scale = 0.0204081628; }
    if (radius < 3) { scale = 0.0399999991; }
    if (radius < 2) { scale = 0.111111112; }
    if (radius < 1) { scale = 1.0; }
    return scale;
}

// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}

// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}

// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, inside);
    let depth: f32 = value.x;
    return select(1.0, depth, inside.x == texel.x && inside.y == texel.y);
}

// umbrage_lit: visibility from one comparison with a texel
fn umbrage_lit(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}

// umbrage_box_count: number of lit texels in the (2r+1) x (2r+1) box around the receiver's texel, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      r, clamped to 0..8. Compilers unroll the loops if it is a constant
fn umbrage_box_count(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let r: i32 = select(select(8, radius, radius < 8), 0, radius < 0);
    let width: i32 = 2 * r + 1;
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let first: vec2f = select(vec2f(0.0, 0.0), floor(coord) - f32(r), compared);
    var count: f32 = 0.0;
    for (var j: i32 = 0; j < 17; j++) {
        if (j >= width) { break; }
        for (var i: i32 = 0; i < 17; i++) {
            if (i >= width) { break; }
            count += umbrage_lit(map, size, first + vec2f(f32(i), f32(j)), receiver);
        }
    }
    return select(f32(width * width), count, compared);
}

// umbrage_box: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count
fn umbrage_box(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let visibility: f32 = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return select(1.0, visibility, visibility < 0.999);  // 121 times the rounded 1/121 is not 1
}
