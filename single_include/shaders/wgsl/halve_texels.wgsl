// umbrage 0.1.0, halve_texels: mean of 2x2 texels, for mip chains. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// halve_texels, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture.

// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
fn umbrage_fetch_clamped(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}

// umbrage_halve_texels: mean of the 2x2 texels behind one texel of the next mip level
//   map, size   map that is read, and its size in texels
//   texel       index in the next level, integers
fn umbrage_halve_texels(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    let at: vec2f = texel * 2.0;
    let a: vec4f = umbrage_fetch_clamped(map, size, at);
    let b: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(1.0, 1.0));
    let sum: vec4f = (a + b) + (c + d);
    return sum * 0.25;
}
