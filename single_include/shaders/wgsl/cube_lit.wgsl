// umbrage 0.1.0, cube_lit: one comparison with a texel of a cube map. Exactness: tier A.
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
// Paste along: cube_face.wgsl, cube_plane.wgsl, cube_point.wgsl, cube_neighbor.wgsl, cube_tile.wgsl, compare.wgsl,
//   texel.wgsl, fetch_depth.wgsl, lit.wgsl; or paste wgsl_joined/cube_lit.wgsl alone.

// umbrage_cube_lit: one comparison with a texel of a cube map
// Returns (visibility, 1.0), or (0.0, 0.0) beyond a corner
//   map, size   atlas of 3 x 2 faces and its size in texels
//   texel       (s, t, face), integers
//   receiver    distance from the light, bias applied
fn umbrage_cube_lit(map: texture_2d<f32>, size: vec2f, texel: vec3f, receiver: f32) -> vec2f {
    let side: f32 = size.y * 0.5;
    let n: vec3f = umbrage_cube_neighbor(texel, side);
    let at: vec2f = umbrage_cube_tile(n.z, side) + vec2f(n.x, n.y);
    let lit: f32 = umbrage_lit(map, size, at, receiver);
    return select(vec2f(lit, 1.0), vec2f(0.0, 0.0), n.z < 0.0);
}
