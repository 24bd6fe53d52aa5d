// umbrage 0.1.0, fetch_clamped: texel of a map, clamped to the nearest one inside. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
// Paste along: texel.wgsl; or paste wgsl_joined/fetch_clamped.wgsl alone.

// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
fn umbrage_fetch_clamped(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}
