// umbrage 0.1.0, pcss_hardware16_shadow: percentage-closer soft shadows (PCSS) at 16 points, one texture bound to two
//   samplers. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// pcss_radius, tier C: within 1/1024 of C++.
// blockers_hardware16_depths, tier C: within 24 x 2^-23 x S of the exact result.
// ellipse_hardware16_shadow, tier C: within 1/128 of C++.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_depth_2d`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Map: `map: texture_depth_2d, map_sampler: sampler_comparison`, a depth texture. Its sampler passes receiver <=
//   depth, clamps to the edge and filters linearly.
// Render target of the map: depth attachment, one sample. Clear to 1.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, -sin, sin, cos) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
fn umbrage_disc_rotation(pixel: vec2f) -> vec4f {
    let whole: vec2f = select(vec2f(0.0, 0.0), floor(pixel), umbrage_inside_texel_space(pixel));
    var v: f32 = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    let quarter: f32 = floor(v * 0.25);
    let base: f32 = v - quarter * 4.0;
    let low: vec2f = select(vec2f(59.0, 24.0), vec2f(64.0, 0.0), base < 0.5);
    let high: vec2f = select(vec2f(24.0, 59.0), vec2f(45.0, 45.0), base < 2.5);
    let first: vec2f = select(high, low, base < 1.5);
    let once: vec2f = select(vec2f(0.0 - first.y, first.x), first, quarter < 0.5);
    let twice: vec2f = select(vec2f(first.y, 0.0 - first.x), vec2f(0.0 - first.x, 0.0 - first.y), quarter < 2.5);
    let turned: vec2f = select(twice, once, quarter < 1.5);
    return vec4f(turned.x, 0.0 - turned.y, turned.y, turned.x);
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_pcss_radius: radius of a penumbra along x and y in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
fn umbrage_pcss_radius(found: vec2f, receiver: f32, softness: vec4f) -> vec2f {
    let forward: bool = umbrage_cleared_depth() > 0.5;
    let mean: f32 = select(select(1.0, 0.0, forward), found.y / found.x, found.x > 0.5);
    let apart: f32 = select(mean - receiver, receiver - mean, forward);
    let radius: vec2f = vec2f(softness.x, softness.y) * 4096.0 * apart;
    let min_radius: f32 = softness.z * 0.0625;
    let max_radius: f32 = softness.w * 0.0625;
    return vec2f(select(min_radius, min(radius.x, max_radius), radius.x > min_radius),
                 select(min_radius, min(radius.y, max_radius), radius.y > min_radius));
}

// umbrage_beyond_far_plane_depths: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane_depths(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain_depths: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain_depths(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane_depths(receiver));
}

// umbrage_texel_depths: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel_depths(map: texture_depth_2d, size: vec2f, texel: vec2f) -> vec4f {
    return vec4f(textureLoad(map, vec2i(texel), 0));
}

// umbrage_texel_inside_depths: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside_depths(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}

// umbrage_fetch_depth_depths: stored depth of a texel, or the far plane's depth outside the map
fn umbrage_fetch_depth_depths(map: texture_depth_2d, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = umbrage_texel_inside_depths(size, texel);
    let value: vec4f = umbrage_texel_depths(map, size, inside);
    let depth: f32 = value.x;
    return select(1.0, depth, inside.x == texel.x && inside.y == texel.y);
}

// umbrage_depth_at_depths: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_depth_at_depths(map: texture_depth_2d, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_fetch_depth_depths(map, size, floor(uv * size));
}

// umbrage_compare_depths: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare_depths(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_blocker_at_depths: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_blocker_at_depths(map: texture_depth_2d, size: vec2f, uv: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_depth_at_depths(map, size, uv);
    return select(vec2f(1.0, stored), vec2f(0.0, 0.0), umbrage_compare_depths(receiver, stored) > 0.5);
}

// umbrage_blockers_hardware16_depths: (number of blockers, sum of their depths) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware16_depths(map: texture_depth_2d, size: vec2f, coord: vec2f, receiver: f32, radius: vec2f,
                                      rotation: vec4f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain_depths(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let wide: f32 = select(0.0, min(radius.x, 255.9375), radius.x > 0.0);
    let high: f32 = select(0.0, min(radius.y, 255.9375), radius.y > 0.0);
    let part: vec2f = vec2f(wide, high) * (1.0 / 1024.0) / size;
    let x: vec2f = vec2f(rotation.x, rotation.z) * part;
    let y: vec2f = vec2f(rotation.y, rotation.w) * part;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at_depths(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 14.0 - y * 2.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
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
