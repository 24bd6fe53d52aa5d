// umbrage 0.1.0, encode_rg14_table: depth to two 8-bit channels through a lookup texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture, direction.

// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
fn umbrage_from_unorm(c: f32) -> f32 {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec2f(c: vec2f) -> vec2f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec3f(c: vec3f) -> vec3f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec4f(c: vec4f) -> vec4f {
    return floor(c * 255.0 + 0.5);
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
fn umbrage_saturate(v: f32) -> f32 {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return select(select(select(umbrage_cleared_depth(), 0.0, v <= 0.0), 1.0, v >= 1.0), v, v > 0.0 && v < 1.0);
}

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

// umbrage_encode_rg14_table: two channels of a 14-bit depth code through a lookup table, integers 0..255
//   table   2048 x 8 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg14_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 8.0), texel));
    return vec2f(k.x, k.y);
}
