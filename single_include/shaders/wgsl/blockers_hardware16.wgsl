// umbrage 0.1.0, blockers_hardware16: blocker search, 16 points of a nearest-texel sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// blockers_hardware16, tier C: within 24 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_depth_at(map: texture_2d<f32>, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}

// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_blocker_at: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_blocker_at(map: texture_2d<f32>, size: vec2f, uv: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_depth_at(map, size, uv);
    return select(vec2f(1.0, stored), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}

// umbrage_blockers_hardware16: (number of blockers, sum of their depths) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                               rotation: vec4f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
}
