// umbrage 0.1.0, tent3: PCF kernel 1 2 1. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: tent3_shadow.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

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

// umbrage_window_sum3: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k1    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
fn umbrage_window_sum3(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, steps: f32, k0: f32,
                       k1: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    let r: vec2f = steps - s;
    let whole: f32 = steps * (k0 + k1 + k0);
    let w0: vec2f = floor(r * k0);
    let w2: vec2f = floor(r * k0 + s * k1);
    let w3: vec2f = floor(s * k0);
    let w1: vec2f = max(whole - (w0 + w2 + w3), vec2f(0.0, 0.0));
    let first: vec2f = texel - 1.0;
    var n: f32 = 0.0;
    var a: vec4f = umbrage_lit_2x2(map, size, first + vec2f(0.0, 0.0), receiver);
    var b: vec4f = umbrage_lit_2x2(map, size, first + vec2f(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return select(whole * whole, n, compared);
}

// umbrage_tent3: PCF under 3 x 3 weights, 1 2 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_tent3(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
