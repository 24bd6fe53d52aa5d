// umbrage 0.1.0, disc_hardware8: disc PCF, 8 fetches from a linear comparison sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// disc_hardware8, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}

// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    return receiver <= 1.0;
}

// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_covered(size: vec2f, uv: vec2f) -> vec2f {
    return vec2f(1.0, 1.0);
}

// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

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

// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, inside);
    let depth: f32 = value.x;
    return select(1.0, depth, inside.x == texel.x && inside.y == texel.y);
}

// umbrage_lit: visibility from one comparison with a texel
fn umbrage_lit(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}

// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
fn umbrage_lit_2x2(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let a: f32 = umbrage_lit(map, size, texel, receiver);
    let b: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 0.0), receiver);
    let c: f32 = umbrage_lit(map, size, texel + vec2f(0.0, 1.0), receiver);
    let d: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 1.0), receiver);
    return vec4f(a, b, c, d);
}

// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_pcf_2x2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let lo: vec2f = 1.0 - hi;
    let lit: vec4f = umbrage_lit_2x2(map, size, texel, receiver);
    let visibility: f32 = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return select(1.0, visibility, compared);
}

// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
fn umbrage_lit_filtered(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2f(-32767.0, -32767.0), vec2f(32767.0, 32767.0)), receiver);
}

// umbrage_lit_between: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   way   from the receiver to where the four texels meet, in texels. Only a receiver's plane uses it
fn umbrage_lit_between(map: texture_2d<f32>, size: vec2f, uv: vec2f, way: vec2f, receiver: f32) -> f32 {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}

// umbrage_lit_at: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
fn umbrage_lit_at(map: texture_2d<f32>, size: vec2f, uv: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let way: vec2f = floor(uv * size + 0.5) - coord;
    let inside: vec2f = umbrage_covered(size, uv);
    let lit: f32 = umbrage_lit_between(map, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}

// umbrage_ellipse_hardware8: PCF over 8 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse_hardware8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                             rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, coord, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 8.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}

// umbrage_disc_hardware8: PCF over 8 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                          rotation: vec4f) -> f32 {
    return umbrage_ellipse_hardware8(map, size, coord, receiver, vec2f(radius, radius), rotation);
}
