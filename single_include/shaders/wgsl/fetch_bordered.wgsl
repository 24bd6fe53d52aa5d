// umbrage 0.1.0, fetch_bordered: texel of a map, or a border value outside it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
// Paste along: texel.wgsl; or paste wgsl_joined/fetch_bordered.wgsl alone.

// umbrage_fetch_bordered: texel of a map, or border outside it
fn umbrage_fetch_bordered(map: texture_2d<f32>, size: vec2f, texel: vec2f, border: vec4f) -> vec4f {
    let at: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0);
    let value: vec4f = umbrage_texel(map, size, at);
    return select(border, value, at.x == texel.x && at.y == texel.y);
}
