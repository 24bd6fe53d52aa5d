// umbrage 0.1.0, disc_hardware16_shadow: disc PCF, 16 fetches from a linear comparison sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// disc_hardware16_shadow, tier C: within 1/128 of C++.
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

// umbrage_lit_at_shadow: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
fn umbrage_lit_at_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, uv: vec2f, coord: vec2f,
                         receiver: f32) -> f32 {
    let way: vec2f = floor(uv * size + 0.5) - coord;
    let inside: vec2f = umbrage_covered_shadow(size, uv);
    let lit: f32 = umbrage_lit_between_shadow(map, map_sampler, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}

// umbrage_ellipse_hardware16_shadow: PCF over 16 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse_hardware16_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, coord: vec2f,
                                     receiver: f32, radius: vec2f, rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain_shadow(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: f32 = 0.0;
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 1.0 - y * 3.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 6.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 8.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 11.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 12.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 1.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 9.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 13.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 14.0 - y * 2.0, coord, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 16.0), umbrage_within_far_plane_shadow(receiver));
    return select(1.0, visibility, compared);
}

// umbrage_disc_hardware16_shadow: PCF over 16 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware16_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, coord: vec2f,
                                  receiver: f32, radius: f32, rotation: vec4f) -> f32 {
    return umbrage_ellipse_hardware16_shadow(map, map_sampler, size, coord, receiver, vec2f(radius, radius), rotation);
}
