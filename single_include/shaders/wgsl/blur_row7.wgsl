// umbrage 0.1.0, blur_row7: binomial mean of texels in a row, for blurs. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// blur_row7, tier B: within 17 x 2^-23 x S of the exact result.
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

// umbrage_blur_row7: mean of 7 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
fn umbrage_blur_row7(map: texture_2d<f32>, size: vec2f, texel: vec2f, along: vec2f) -> vec4f {
    var sum: vec4f = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    let before1: vec4f = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    let after1: vec4f = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    let before2: vec4f = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    let after2: vec4f = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    let before3: vec4f = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    let after3: vec4f = umbrage_fetch_clamped(map, size, texel + along * 3.0);
    sum = sum + (before3 + after3) * (1.0 / 64.0);
    return sum;
}
