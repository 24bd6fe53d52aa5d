// umbrage 0.1.0, four_tap_hardware: mean of four taps from a nearest-texel sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// four_tap_hardware, tier C: within 39 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
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

// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_depth_at(map: texture_2d<f32>, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}

// umbrage_four_tap_hardware: mean of the shadow test at four taps of a nearest-texel sampler
// Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps from (0.0, 0.0) to (1.0, 1.0) over the map
//                All are lit where the mean of |x| + |y| is 2^15 texels or more
//   receiver     receiver depth in [0, 1], bias applied
fn umbrage_four_tap_hardware(map: texture_2d<f32>, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f,
                             receiver: f32) -> f32 {
    let sum: vec2f = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    let compared: bool = select((sum.x + sum.y < 131072.0), false, umbrage_beyond_far_plane(receiver));
    let count: f32 = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return select(1.0, count * 0.25, compared);
}
