// umbrage 0.1.0, blockers16: blocker search over a disc's points. Exactness: tier A.
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
// Paste along: disc_tap.wgsl, texel.wgsl, fetch_depth.wgsl, compare.wgsl, cleared_depth.wgsl, distance_code.wgsl,
//   blocker.wgsl; or paste wgsl_joined/blockers16.wgsl alone.

// umbrage_blockers16: (number of blockers, sum of their distance codes) at 16 points of a disc
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in 1/16 texel, an integer from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
fn umbrage_blockers16(map: texture_2d<f32>, size: vec2f, position: vec2f, receiver: f32, radius: f32,
                      rotation: vec2f) -> vec2f {
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(14.0, -2.0), rotation, radius), receiver);
    return n;
}
