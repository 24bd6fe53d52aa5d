// umbrage 0.1.0, fetch_depth: stored depth of a texel, outside the map of the nearest one inside. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Paste along: texel.wgsl, fetch_clamped.wgsl, decode.wgsl; or paste wgsl_joined/fetch_depth.wgsl alone.

// umbrage_fetch_depth: stored depth of a texel, outside the map of the nearest one inside
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    return umbrage_decode(umbrage_fetch_clamped(map, size, texel));
}
