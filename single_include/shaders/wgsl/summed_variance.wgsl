// umbrage 0.1.0, summed_variance: variance shadow over a box of any size, from a SAT. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// summed_variance, tier C: within 1/65536 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, map_covers.wgsl,
//   cleared_depth.wgsl, texel.wgsl, correct_quotient.wgsl, floor_divide.wgsl, box_moments.wgsl; or paste
//   wgsl_joined/summed_variance.wgsl alone.

// umbrage_summed_variance: variance shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_variance_table and its size: the shadow map's plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   codes       2^bits of the table
fn umbrage_summed_variance(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           codes: f32) -> f32 {
    let last: vec2f = size - 1.0;
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(last, coord));
    let texel: vec2f = select(vec2f(0.0, 0.0), clamp(floor(coord), vec2f(0.0, 0.0), last - 1.0), compared);
    let first: vec2f = max(texel - radius, vec2f(0.0, 0.0));
    let end: vec2f = min(texel + radius + 1.0, last);
    let m: vec4f = umbrage_box_moments(map, size, first, end);
    let sides: vec2f = end - first;
    let n: f32 = sides.x * sides.y;
    let share: f32 = m.y / n;
    let variance: f32 = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    let scaled: f32 = receiver * codes;
    let t: f32 = select(codes - scaled, scaled, umbrage_cleared_depth() > 0.5);
    let d: f32 = (t - 1.0 - m.x) - share;
    let behind: f32 = select(0.0, variance / (variance + d * d), d > 0.0);
    return select(1.0, select(behind, 1.0, d <= 0.0), compared);
}
