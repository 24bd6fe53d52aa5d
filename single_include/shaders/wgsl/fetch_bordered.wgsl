// umbrage 0.1.0, fetch_bordered: texel of a map, outside a border value. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Paste along: texel.wgsl, fetch_clamped.wgsl, inside_map.wgsl; or paste wgsl_joined/fetch_bordered.wgsl alone.

// umbrage_fetch_bordered: texel of a map, or border outside of it
fn umbrage_fetch_bordered(map: texture_2d<f32>, size: vec2f, texel: vec2f, border: vec4f) -> vec4f {
    let value: vec4f = umbrage_fetch_clamped(map, size, texel);
    return select(border, value, umbrage_inside_map(size, texel));
}
