// umbrage 0.1.0, fetch_depth: stored depth of a texel, outside the map that of the far plane. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Paste along: texel.wgsl, decode.wgsl, cleared_depth.wgsl, border_depth.wgsl; or paste wgsl_joined/fetch_depth.wgsl
//   alone.

// umbrage_fetch_depth: stored depth of a texel, outside the map that of the far plane
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0);
    let depth: f32 = umbrage_decode(umbrage_texel(map, size, inside));
    return select(umbrage_border_depth(), depth, inside.x == texel.x && inside.y == texel.y);
}
