// umbrage 0.1.0, window_hardware7: 7x7 kernel, 16 fetches from a linear comparison sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// window_hardware7, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: window_hardware7_shadow.
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

// umbrage_window_hardware7: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
fn umbrage_window_hardware7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32, k2: f32,
                            k3: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    let w0: vec2f = k0 + k1 + s * -k1;
    let p0: vec2f = (texel + (-k0 * 2.5 - k1 * 1.5 + s * (k0 + k1 * 1.5)) / w0) / size;
    let v0: vec2f = w0 * umbrage_covered(size, p0);
    let w1: vec2f = k2 + k3 + s * (k1 - k3);
    let p1: vec2f = (texel + (-k2 * 0.5 + k3 * 0.5 + s * (-k1 * 0.5 + k2 - k3 * 0.5)) / w1) / size;
    let v1: vec2f = w1 * umbrage_covered(size, p1);
    let w2: vec2f = k1 + k2 + s * (-k1 + k3);
    let p2: vec2f = (texel + (k1 * 2.5 + k2 * 1.5 + s * (-k1 * 2.5 + k2 + k3 * 1.5)) / w2) / size;
    let v2: vec2f = w2 * umbrage_covered(size, p2);
    let w3: vec2f = k0 + s * k1;
    let p3: vec2f = (texel + (k0 * 3.5 + s * (k0 + k1 * 3.5)) / w3) / size;
    let v3: vec2f = w3 * umbrage_covered(size, p3);
    let inside: vec2f = v0 + v1 + v2 + v3;
    // ... - s: from the receiver to where the four texels of a fetch meet
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p0.y), vec2f(-2.5, -2.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p0.y), vec2f(-0.5, -2.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p0.y), vec2f(1.5, -2.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p0.y), vec2f(3.5, -2.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p1.y), vec2f(-2.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p1.y), vec2f(-0.5, -0.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p1.y), vec2f(1.5, -0.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p1.y), vec2f(3.5, -0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p2.y), vec2f(-2.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p2.y), vec2f(-0.5, 1.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p2.y), vec2f(1.5, 1.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p2.y), vec2f(3.5, 1.5) - s, receiver);
    n += v2.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, vec2f(p0.x, p3.y), vec2f(-2.5, 3.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, vec2f(p1.x, p3.y), vec2f(-0.5, 3.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, vec2f(p2.x, p3.y), vec2f(1.5, 3.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, vec2f(p3.x, p3.y), vec2f(3.5, 3.5) - s, receiver);
    n += v3.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
