// umbrage 0.1.0, pcf_2x2_dx_sdk: bilinear 2x2 PCF of the DirectX SDK sample, plain floats. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// pcf_2x2_dx_sdk, tier B: within 20 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, direction.

// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
fn umbrage_compare_dx_sdk(receiver: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(1.0, 0.0, limit < receiver);
}

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
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

// umbrage_pcf_2x2_dx_sdk: 2x2 PCF of the DirectX SDK sample. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], no bias applied
//   epsilon     depth added to each stored depth
fn umbrage_pcf_2x2_dx_sdk(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, epsilon: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x);
    let weight: vec2f = x - texel;
    let a: f32 = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    let right: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 0.0));
    let above: f32 = umbrage_fetch_depth(map, size, texel + vec2f(0.0, 1.0));
    let beyond: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 1.0));
    let b: f32 = umbrage_compare_dx_sdk(receiver, right, epsilon);
    let c: f32 = umbrage_compare_dx_sdk(receiver, above, epsilon);
    let d: f32 = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    let low: f32 = a + weight.x * (b - a);
    let high: f32 = c + weight.x * (d - c);
    let visibility: f32 = low + weight.y * (high - low);
    return select(1.0, visibility, compared);
}
