// umbrage 0.1.0, window_hardware5: 5x5 kernel, 9 fetches from a linear comparison sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// window_hardware5, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: window_hardware5_shadow.
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
//   or paste wgsl_joined/window_hardware5.wgsl alone.

// umbrage_window_hardware5: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
fn umbrage_window_hardware5(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32,
                            k2: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k2 + k1 + k0;
    let b0: vec2f = k1 + s * (k0 - k1);
    let w0: vec2f = k0 + k1 - s * k1;
    let p0: vec2f = (texel - 1.5 + b0 / w0) / size;
    let b1: vec2f = k1 + s * (k2 - k1);
    let w1: vec2f = vec2f(k2 + k1, k2 + k1);
    let p1: vec2f = (texel + 0.5 + b1 / w1) / size;
    let b2: vec2f = s * k0;
    let w2: vec2f = k0 + s * k1;
    let p2: vec2f = (texel + 2.5 + b2 / w2) / size;
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p2.y), receiver);
    n += w2.y * row;
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
