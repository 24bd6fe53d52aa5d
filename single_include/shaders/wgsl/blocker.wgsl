// umbrage 0.1.0, blocker: count and distance code of one possible blocker. Exactness: tier A.
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
// Paste along: texel.wgsl, fetch_depth.wgsl, compare.wgsl, cleared_depth.wgsl, distance_code.wgsl; or paste
//   wgsl_joined/blocker.wgsl alone.

// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
fn umbrage_blocker(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_fetch_depth(map, size, texel);
    let code: f32 = umbrage_distance_code(stored);
    return select(vec2f(1.0, code), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}
