// umbrage 0.1.0, window_hardware5_shadow: 5x5 kernel, 9 fetches from a linear comparison sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// window_hardware5_shadow, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_depth_2d, map_sampler: sampler_comparison`, a depth texture. Its sampler passes receiver <=
//   depth, clamps to the edge and filters linearly.
// Render target of the map: depth attachment, one sample. Clear to 1.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, outside, direction.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_beyond_far_plane_shadow: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane_shadow(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain_shadow: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain_shadow(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane_shadow(receiver));
}

// umbrage_within_far_plane_shadow: true if a receiver is a number and not beyond the far plane
fn umbrage_within_far_plane_shadow(receiver: f32) -> bool {
    return receiver <= 1.0;
}

// umbrage_covered_shadow: share of the texels around a point that lie in the map, along each axis
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_covered_shadow(size: vec2f, uv: vec2f) -> vec2f {
    return clamp((0.5 + size * 0.5) - abs(uv - 0.5) * size, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
}

// umbrage_lit_between_shadow: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
fn umbrage_lit_between_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, uv: vec2f,
                              way: vec2f, receiver: f32) -> f32 {
    return textureSampleCompareLevel(map, map_sampler, uv, receiver);
}

// umbrage_window_hardware5_shadow: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
fn umbrage_window_hardware5_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, coord: vec2f,
                                   receiver: f32, k0: f32, k1: f32, k2: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain_shadow(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k2 + k1 + k0;
    let w0: vec2f = k0 + k1 + s * -k1;
    let p0: vec2f = (texel + (-k0 * 1.5 - k1 * 0.5 + s * (k0 + k1 * 0.5)) / w0) / size;
    let v0: vec2f = w0 * umbrage_covered_shadow(size, p0);
    let w1: vec2f = vec2f(k1 + k2, k1 + k2);
    let p1: vec2f = (texel + (k1 * 1.5 + k2 * 0.5 + s * (-k1 + k2)) / w1) / size;
    let v1: vec2f = w1 * umbrage_covered_shadow(size, p1);
    let w2: vec2f = k0 + s * k1;
    let p2: vec2f = (texel + (k0 * 2.5 + s * (k0 + k1 * 2.5)) / w2) / size;
    let v2: vec2f = w2 * umbrage_covered_shadow(size, p2);
    let inside: vec2f = v0 + v1 + v2;
    // ... - s: from the receiver to where the four texels of a fetch meet
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p0.x, p0.y), vec2f(-1.5, -1.5) - s, receiver);
    row += v1.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p1.x, p0.y), vec2f(0.5, -1.5) - s, receiver);
    row += v2.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p2.x, p0.y), vec2f(2.5, -1.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p0.x, p1.y), vec2f(-1.5, 0.5) - s, receiver);
    row += v1.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p1.x, p1.y), vec2f(0.5, 0.5) - s, receiver);
    row += v2.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p2.x, p1.y), vec2f(2.5, 0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p0.x, p2.y), vec2f(-1.5, 2.5) - s, receiver);
    row += v1.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p1.x, p2.y), vec2f(0.5, 2.5) - s, receiver);
    row += v2.x * umbrage_lit_between_shadow(map, map_sampler, size, vec2f(p2.x, p2.y), vec2f(2.5, 2.5) - s, receiver);
    n += v2.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane_shadow(receiver));
    return select(1.0, visibility, compared);
}
