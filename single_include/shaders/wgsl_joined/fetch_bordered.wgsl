// umbrage 0.1.0, fetch_bordered: texel of a map, outside a border value. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.

// umbrage_inside_map: whether a texel is one of a map's of size texels
fn umbrage_inside_map(size: vec2f, texel: vec2f) -> bool {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}

// umbrage_texel: value of a texel inside the map; whole numbers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
fn umbrage_fetch_clamped(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}

// umbrage_fetch_bordered: texel of a map, or border outside of it
fn umbrage_fetch_bordered(map: texture_2d<f32>, size: vec2f, texel: vec2f, border: vec4f) -> vec4f {
    let value: vec4f = umbrage_fetch_clamped(map, size, texel);
    return select(border, value, umbrage_inside_map(size, texel));
}
