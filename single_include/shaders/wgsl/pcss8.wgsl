// umbrage 0.1.0, pcss8: percentage-closer soft shadows (PCSS), 8 points twice. Exactness: tier A.
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
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, cleared_depth.wgsl,
//   distance_code.wgsl, penumbra.wgsl, disc_tap.wgsl, texel.wgsl, fetch_depth.wgsl, compare.wgsl, blocker.wgsl,
//   blockers8.wgsl, correct_quotient.wgsl, floor_divide.wgsl, disc_radius.wgsl, lit.wgsl, disc8.wgsl; or paste
//   wgsl_joined/pcss8.wgsl alone.

// umbrage_pcss8: percentage-closer soft shadows (PCSS), 8 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_pcss8(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f,
                 rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_disc8(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
