// umbrage 0.1.0, encode_rg9_table: depth to two 8-bit channels through a lookup texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: cleared_depth.wgsl, saturate.wgsl, from_unorm.wgsl, texel.wgsl, fetch_clamped.wgsl; or paste
//   wgsl_joined/encode_rg9_table.wgsl alone.

// umbrage_encode_rg9_table: two channels of a 9-bit depth code through a lookup table, integers 0..255
//   table   512 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg9_table(table: texture_2d<f32>, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    let row: f32 = floor(x * (1.0 / 512.0));
    let texel: vec2f = vec2f(x - row * 512.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(512.0, 1.0), texel));
    return vec2f(k.x, k.y);
}
