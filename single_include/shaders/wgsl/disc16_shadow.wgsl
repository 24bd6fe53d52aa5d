// umbrage 0.1.0, disc16_shadow: disc PCF, 16 points, rotated per pixel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_depth_2d, map_sampler: sampler_comparison`, a depth texture. Its sampler passes receiver <=
//   depth, clamps to the edge and filters nearest.
// Render target of the map: depth attachment, one sample. Clear to 1.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, outside, direction.

// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
fn umbrage_disc_radius(radius: f32) -> f32 {
    let inside: f32 = select(0.0, floor(radius * 16.0), radius > 0.0);
    return select(inside, 4095.0, radius >= 255.9375);
}

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     along x and y, in 1/16 texel, integers from 0 to 4095
fn umbrage_disc_tap(position: vec2f, p: vec2f, rotation: vec4f, radius: vec2f) -> vec2f {
    let at: vec2f = position * (1.0 / 256.0);
    let texel: vec2f = floor(at);
    let within: vec2f = clamp(at - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));  // no sum is regrouped across it
    let wide: vec2f = vec2f(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    let high: vec2f = vec2f(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    let x: f32 = wide.x * p.x + within.x + wide.y * p.y;
    let y: f32 = high.x * p.x + within.y + high.y * p.y;
    return texel + floor(vec2f(x, y));
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

// umbrage_ellipse16_shadow: PCF over a rotated ellipse of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse16_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, coord: vec2f,
                            receiver: f32, radius: vec2f, rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain_shadow(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    var n: f32 = 0.0;
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(0.0, 7.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(8.0, -5.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(11.0, 5.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(-12.0, 4.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(7.0, 11.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(-9.0, 10.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(-13.0, -4.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(7.0, -12.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(-7.0, -12.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, vec2f(14.0, -2.0), rotation, radius), receiver);
    return select(1.0, n * (1.0 / 16.0), compared);
}

// umbrage_disc16_shadow: PCF over a rotated disc of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc16_shadow(map: texture_depth_2d, map_sampler: sampler_comparison, size: vec2f, coord: vec2f,
                         receiver: f32, radius: f32, rotation: vec4f) -> f32 {
    let rho: f32 = umbrage_disc_radius(radius);
    return umbrage_ellipse16_shadow(map, map_sampler, size, coord, receiver, vec2f(rho, rho), rotation);
}
