// umbrage 0.1.0, summed_moments: moment shadow over a box of any size, from a SAT. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// summed_moments, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, map_covers.wgsl, texel.wgsl,
//   box_mean.wgsl, from_optimized_moments.wgsl, bias_moments.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl,
//   moment_atoms.wgsl, decode_msm.wgsl; or paste wgsl_joined/summed_moments.wgsl alone.

// umbrage_summed_moments: moment shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_moment_table and its size: twice the shadow map's width plus two, its height plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   bias        (6e-5, 0.628)
fn umbrage_summed_moments(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                          bias: vec2f) -> f32 {
    let last: vec2f = vec2f(size.x * 0.5, size.y) - 1.0;
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(last, coord));
    let texel: vec2f = select(vec2f(0.0, 0.0), clamp(floor(coord), vec2f(0.0, 0.0), last - 1.0), compared);
    let first: vec2f = max(texel - radius, vec2f(0.0, 0.0));
    let end: vec2f = min(texel + radius + 1.0, last);
    let turned: vec4f = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    let lit: f32 = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return select(1.0, lit, compared);
}
