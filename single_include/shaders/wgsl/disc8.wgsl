// umbrage 0.1.0, disc8: disc PCF, 8 points, rotated per pixel. Exactness: tier A.
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
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, disc_radius.wgsl,
//   disc_tap.wgsl, compare.wgsl, texel.wgsl, fetch_depth.wgsl, lit.wgsl; or paste wgsl_joined/disc8.wgsl alone.

// umbrage_disc8: PCF over a rotated disc of 8 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_disc8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let rho: f32 = umbrage_disc_radius(radius);
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(3.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-4.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-12.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, -7.0), rotation, rho), receiver);
    return select(1.0, n * (1.0 / 8.0), compared);
}
