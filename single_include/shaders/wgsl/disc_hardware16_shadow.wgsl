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
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
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

// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare_shadow(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_lit_at_shadow: 2x2 comparisons around a point, weighted by the sampler, with the far plane outside the map
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
fn umbrage_lit_at_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, uv: vec2f,
                         receiver: f32) -> f32 {
    let lit: f32 = textureSampleCompareLevel(map, map_sampler, uv, receiver);
    let outside: f32 = umbrage_compare_shadow(receiver, 1.0);
    let inside: vec2f = clamp((0.5 + size * 0.5) - abs(uv - 0.5) * size, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}

// umbrage_disc_hardware16_shadow: PCF over 16 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware16_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, coord: vec2f,
                                  receiver: f32, radius: f32, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain_shadow(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: f32 = 0.0;
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 14.0 - y * 2.0, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 16.0), umbrage_within_far_plane_shadow(receiver));
    return select(1.0, visibility, compared);
}
