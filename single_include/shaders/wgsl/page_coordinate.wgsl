// umbrage 0.1.0, page_coordinate: position of a receiver in the atlas page that holds it. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture.

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

// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_page_coordinate: (x, y) of a receiver in an atlas page with its gutter, and (z, w) the page's first texel
//   table   page table, RGBA8, nearest filter
//   size    size of the table, in texels
//   coord   receiver position, 1.0 to 2.0 across the table without its border
//   page    side of a page, in texels
//   gutter  border around a page, in texels
fn umbrage_page_coordinate(table: texture_2d<f32>, size: vec2f, coord: vec2f, page: f32, gutter: f32) -> vec4f {
    // neither max changes a value; compilers cannot regroup sums across max and clamp
    let sides: vec2f = max(size - 2.0, vec2f(1.0, 1.0));
    let before: vec2f = max(size - 3.0, vec2f(0.0, 0.0));
    let cell: vec2f = min(max(vec2f(0.0, 0.0), coord * sides - before), size - 1.0);
    let texel: vec2i = vec2i(cell);  // the first texel for a NaN
    let entry: vec4f = umbrage_from_unorm_vec4f(umbrage_texel(table, size, vec2f(texel)));
    let slot: vec2f = vec2f(entry.x, entry.y);
    let across: f32 = entry.z + entry.w * 256.0;
    let within: vec2f = clamp(fract(coord * across), vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let at: vec2f = within * page + select(32768.0, gutter, across > 0.0);
    return vec4f(at, slot * (page + gutter * 2.0));
}
