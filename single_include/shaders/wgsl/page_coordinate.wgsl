// umbrage 0.1.0, MIT License: page_coordinate
// Paste along: texel.wgsl, from_unorm.wgsl

// umbrage_page_coordinate: a receiver in a page of an atlas: texels of the page with its gutter, the page's first texel
//   table, size   page table, RGBA8, nearest filter;   coord   receiver, from 1.0 to 2.0 across all but its border
//   page, gutter  side of a page and what it has around it, texels
fn umbrage_page_coordinate(table: texture_2d<f32>, size: vec2f, coord: vec2f, page: f32, gutter: f32) -> vec4f {
    let cell: vec2f = min(max(vec2f(0.0, 0.0), coord * (size - 2.0) - (size - 3.0)), size - 1.0);
    let texel: vec2i = vec2i(cell);  // of a NaN the first
    let entry: vec4f = umbrage_texel(table, size, vec2f(texel));
    let slot: vec2f = umbrage_from_unorm_vec2f(vec2f(entry.x, entry.y));
    let across: f32 = floor(entry.z * 255.0 + entry.w * 65280.0 + 0.5);  // one of the two is 0.0
    let at: vec2f = fract(coord * across) * page + select(32768.0, gutter, across > 0.0);
    return vec4f(at, slot * (page + gutter * 2.0));
}
