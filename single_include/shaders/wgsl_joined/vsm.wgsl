// umbrage 0.1.0, vsm: visibility from a map of encode_vsm's texels. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// vsm, tier C: within 165 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Render target of vsm: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_vsm of the far plane's
//   depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}

// umbrage_chebyshev: share of depths that may be as far as the receiver or farther, at most; 0.0 where something is NaN
//   m  mean of the depths, mean of their squares;   receiver  on the same scale;   min_variance  0.0 or more
fn umbrage_chebyshev(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let difference: f32 = m.y - m.x * m.x;
    let variance: f32 = select(min_variance, difference, difference > min_variance);
    let distance: f32 = receiver - m.x;
    let sum: f32 = variance + distance * distance;
    let p: f32 = variance / sum;
    return select(select(0.0, min(p, 1.0), p > 0.0), 1.0, receiver <= m.x);  // a GPU's v / v may be more than 1.0
}

// umbrage_beyond_far_plane: whether a receiver is behind the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain: whether a filter compares; outside texel space and beyond the far plane all is lit
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}

// umbrage_map_covers: whether a receiver of a prefiltered map or a table lies in the map; elsewhere it is lit
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}

// umbrage_texel: value of a texel inside the map
//   map    where its texels lie; a sampler that reads them filters by nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
fn umbrage_fetch_clamped(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}

// umbrage_fetch_bilinear: mean of the four texels around a point, weights in steps of 1/256
//   coord  in texels, first center at (0.5, 0.5)
fn umbrage_fetch_bilinear(map: texture_2d<f32>, size: vec2f, coord: vec2f) -> vec4f {
    let x: vec2f = floor(coord * 256.0) - 128.0;
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already; compilers cannot regroup sums across the clamp
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let lo: vec2f = 256.0 - hi;  // of 1.0 - hi compilers would make an interpolation, which rounds otherwise
    let a: vec4f = umbrage_fetch_clamped(map, size, texel);
    let b: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 1.0));
    let low: vec4f = a * lo.x + b * hi.x;
    let high: vec4f = c * lo.x + d * hi.x;
    let sum: vec4f = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}

// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
fn umbrage_decode_vsm(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}

// umbrage_vsm: visibility from a map of encode_vsm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   min_variance  0.0 or more
fn umbrage_vsm(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_vsm(vec2f(m.x, m.y), receiver, min_variance);
    return select(1.0, lit, compared);
}
