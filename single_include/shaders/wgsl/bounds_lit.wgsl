// umbrage 0.1.0, bounds_lit: visibility from depth bounds, an early exit of a filter. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, compare.wgsl, texel.wgsl,
//   fetch_clamped.wgsl; or paste wgsl_joined/bounds_lit.wgsl alone.

// umbrage_bounds_lit: early exit of a filter. Returns 1.0 where all texels are lit, 0.0 where none is
// Returns -1.0 where the bounds do not decide it: call the filter there
//   bounds, size      map of the texels' smallest and largest depths, and its size in texels
//   coord, receiver   as passed to the filter
//   place             maps a receiver to its bounds, from make_filter_bounds
fn umbrage_bounds_lit(bounds: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, place: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let b: vec4f = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    let all: f32 = umbrage_compare(receiver, b.x);
    let some: f32 = umbrage_compare(receiver, b.y);
    let known: f32 = select(-1.0, all, b.x <= b.y && all == some);  // NaN bounds decide nothing
    return select(1.0, known, compared);
}
