// umbrage 0.1.0, lit_2x2: visibility from comparisons with 2x2 texels. Exactness: tier A.
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

// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
fn umbrage_lit_2x2(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let a: f32 = umbrage_lit(map, size, texel, receiver);
    let b: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 0.0), receiver);
    let c: f32 = umbrage_lit(map, size, texel + vec2f(0.0, 1.0), receiver);
    let d: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 1.0), receiver);
    return vec4f(a, b, c, d);
}
