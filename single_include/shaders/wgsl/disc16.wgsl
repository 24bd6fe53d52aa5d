// umbrage 0.1.0, disc16: disc PCF, 16 points, rotated per pixel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: disc16_shadow.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

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

// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
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

// umbrage_ellipse16: PCF over a rotated ellipse of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_ellipse16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                     rotation: vec4f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(14.0, -2.0), rotation, radius), receiver);
    return select(1.0, n * (1.0 / 16.0), compared);
}

// umbrage_disc16: PCF over a rotated disc of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec4f) -> f32 {
    let rho: f32 = umbrage_disc_radius(radius);
    return umbrage_ellipse16(map, size, coord, receiver, vec2f(rho, rho), rotation);
}
