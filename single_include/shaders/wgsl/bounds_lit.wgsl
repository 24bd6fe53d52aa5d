// umbrage 0.1.0, bounds_lit: visibility where bounds of a filter's texels suffice. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, compare.wgsl, texel.wgsl,
//   fetch_clamped.wgsl; or paste wgsl_joined/bounds_lit.wgsl alone.

// umbrage_bounds_lit: 1.0 where all texels of a filter are lit, 0.0 where none is, else -1.0: ask the filter
//   bounds, size  a map of the texels' least and greatest depths, and its size in texels;   place  what goes with it
//   coord, receiver  as the filter takes them
fn umbrage_bounds_lit(bounds: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, place: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let b: vec4f = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    let all: f32 = umbrage_compare(receiver, b.x);
    let some: f32 = umbrage_compare(receiver, b.y);
    let known: f32 = select(-1.0, all, b.x <= b.y && all == some);  // not of a NaN
    return select(1.0, known, compared);
}
