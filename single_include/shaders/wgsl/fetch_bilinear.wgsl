// umbrage 0.1.0, fetch_bilinear: bilinear mean of the four texels around a point. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// fetch_bilinear, tier B: within 19 x 2^-23 x S of the exact result.
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

// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
fn umbrage_fetch_bilinear(map: texture_2d<f32>, size: vec2f, coord: vec2f) -> vec4f {
    let x: vec2f = floor(coord * 256.0) - 128.0;
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let lo: vec2f = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    let a: vec4f = umbrage_fetch_clamped(map, size, texel);
    let b: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 1.0));
    let low: vec4f = a * lo.x + b * hi.x;
    let high: vec4f = c * lo.x + d * hi.x;
    let sum: vec4f = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
