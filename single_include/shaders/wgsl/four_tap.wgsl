// umbrage 0.1.0, four_tap: mean of four taps, each with its own coordinates. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

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

// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_four_tap: mean of the shadow test at four taps. Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps in texels. All are lit where their mean magnitude is 2^15 or more along an axis
//   receiver     receiver depth in [0, 1], bias applied
fn umbrage_four_tap(map: texture_2d<f32>, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f, receiver: f32) -> f32 {
    let a_texel: vec2f = floor(a);
    let b_texel: vec2f = floor(b);
    let c_texel: vec2f = floor(c);
    let d_texel: vec2f = floor(d);
    let sum: vec2f = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two different limits on purpose: Mesa turns a single one into max(x, y) < limit, which loses a NaN
    let compared: bool = select(sum.x < 131072.0 && sum.y * 2.0 < 262144.0, false, umbrage_beyond_far_plane(receiver));
    let count: f32 = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return select(1.0, count * 0.25, compared);
}
