// umbrage 0.1.0, hard_shadow: unfiltered shadow test of the nearest texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_depth_2d, map_sampler: sampler_comparison`, a depth texture. Its sampler passes receiver <=
//   depth, clamps to the edge and filters nearest.
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

// umbrage_texel_inside_shadow: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside_shadow(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}

// umbrage_lit_texel_shadow: the sampler's comparison with a texel inside the map. NaN is in shadow
fn umbrage_lit_texel_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, texel: vec2f,
                            receiver: f32) -> f32 {
    let lit: f32 = textureSampleCompareLevel(map, map_sampler, (texel + 0.5) / size, receiver);
    return select(0.0, lit, receiver > 0.0) + select(0.0, lit, receiver <= 0.0);
}

// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare_shadow(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_lit_shadow: compares the receiver with one texel. Outside the map it compares with the far plane
fn umbrage_lit_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, texel: vec2f,
                      receiver: f32) -> f32 {
    let inside: vec2f = umbrage_texel_inside_shadow(size, texel);
    let lit: f32 = umbrage_lit_texel_shadow(map, map_sampler, size, inside, receiver);
    let outside: f32 = umbrage_compare_shadow(receiver, 1.0);
    return select(outside, lit, inside.x == texel.x && inside.y == texel.y);
}

// umbrage_hard_shadow: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_hard_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, coord: vec2f,
                       receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain_shadow(coord, receiver);
    let texel: vec2f = select(vec2f(0.0, 0.0), floor(coord), compared);  // no branch: fetches of several taps overlap
    let lit: f32 = umbrage_lit_shadow(map, map_sampler, size, texel, receiver);
    return select(1.0, lit, compared);
}
