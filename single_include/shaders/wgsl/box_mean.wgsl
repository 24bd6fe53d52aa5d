// umbrage 0.1.0, box_mean: mean of four integers over a box, from a SAT in two halves. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// box_mean, tier C: within 19 x 2^-23 x S of the exact result.
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

// umbrage_box_mean: mean over a box of four integers below 65536.0
//   map, size    table from make_moment_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
fn umbrage_box_mean(map: texture_2d<f32>, size: vec2f, first: vec2f, end: vec2f) -> vec4f {
    let right: f32 = size.x * 0.5;
    var a: vec4f = umbrage_texel(map, size, end);
    var b: vec4f = umbrage_texel(map, size, vec2f(first.x, end.y));
    var c: vec4f = umbrage_texel(map, size, vec2f(end.x, first.y));
    var d: vec4f = umbrage_texel(map, size, first);
    let low: vec4f = (a - b) - (c - d);
    let carry: vec4f = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, vec2f(right + end.x, end.y));
    b = umbrage_texel(map, size, vec2f(right + first.x, end.y));
    c = umbrage_texel(map, size, vec2f(right + end.x, first.y));
    d = umbrage_texel(map, size, vec2f(right + first.x, first.y));
    let above: vec4f = (a - b) - (c - d) + carry;
    let high: vec4f = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    let sum: vec4f = high * 65536.0 + (low - carry * 65536.0);
    let sides: vec2f = end - first;
    return sum / (sides.x * sides.y);
}
