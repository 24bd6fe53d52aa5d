// umbrage 0.1.0, pcf_2x2_cube: bilinear 2x2 PCF of a cube map, across its edges. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// pcf_2x2_cube, tier C: within 33 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, cube_face.wgsl,
//   cube_plane.wgsl, cube_point.wgsl, cube_neighbor.wgsl, cube_tile.wgsl, compare.wgsl, texel.wgsl, fetch_depth.wgsl,
//   lit.wgsl, cube_lit.wgsl; or paste wgsl_joined/pcf_2x2_cube.wgsl alone.

// umbrage_pcf_2x2_cube: bilinear 2x2 PCF across the edges of a cube map. Returns visibility, 1.0 = lit
//   map, size   atlas of 3 x 2 faces and its size in texels
//   at          (s, t, face): s and t in texels of the face, from 0.0 on
//   receiver    distance from the light, bias applied
fn umbrage_pcf_2x2_cube(map: texture_2d<f32>, size: vec2f, at: vec3f, receiver: f32) -> f32 {
    let coord: vec2f = vec2f(at.x, at.y);
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0 + 0.5) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let lo: vec2f = 1.0 - hi;
    var sum: vec2f = umbrage_cube_lit(map, size, vec3f(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return select(1.0, sum.x / sum.y, compared && sum.y > 0.0);
}
