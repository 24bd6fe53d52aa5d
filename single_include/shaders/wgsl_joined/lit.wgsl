// umbrage 0.1.0, lit: one comparison with a texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Outside the map all is lit. For the nearest texel inside instead: bind() with outside clamped.

// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_texel: value of a texel inside the map; whole numbers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_decode: depth of a texel's value
fn umbrage_decode(value: vec4f) -> f32 {
    return value.x;
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_border_depth: what texels outside the map count as, the far plane
fn umbrage_border_depth() -> f32 {
    return umbrage_cleared_depth();
}

// umbrage_fetch_depth: stored depth of a texel, outside the map that of the far plane
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0);
    let depth: f32 = umbrage_decode(umbrage_texel(map, size, inside));
    return select(umbrage_border_depth(), depth, inside.x == texel.x && inside.y == texel.y);
}

// umbrage_lit: visibility of one comparison with a texel
fn umbrage_lit(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
