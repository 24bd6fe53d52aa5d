// umbrage 0.1.0, disc_hardware32: disc PCF, 32 fetches from a linear comparison sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// disc_hardware32, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, within_far_plane.wgsl,
//   compare.wgsl, texel.wgsl, fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl, pcf_2x2.wgsl, lit_filtered.wgsl, lit_at.wgsl;
//   or paste wgsl_joined/disc_hardware32.wgsl alone.

// umbrage_disc_hardware32: PCF over 32 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware32(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 32.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
