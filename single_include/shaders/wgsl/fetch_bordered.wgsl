// umbrage 0.1.0, fetch_bordered: texel of a map, or a border value outside it. Exactness: tier A.
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

// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}

// umbrage_fetch_bordered: texel of a map, or border outside it
fn umbrage_fetch_bordered(map: texture_2d<f32>, size: vec2f, texel: vec2f, border: vec4f) -> vec4f {
    let at: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, at);
    return select(border, value, at.x == texel.x && at.y == texel.y);
}
