// umbrage 0.1.0, pcss_radius: penumbra radius from the mean depth of blockers. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// pcss_radius, tier C: within 1/1024 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_pcss_radius: radius of a penumbra along x and y in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
fn umbrage_pcss_radius(found: vec2f, receiver: f32, softness: vec4f) -> vec2f {
    let forward: bool = umbrage_cleared_depth() > 0.5;
    let mean: f32 = select(select(1.0, 0.0, forward), found.y / found.x, found.x > 0.5);
    let apart: f32 = select(mean - receiver, receiver - mean, forward);
    let radius: vec2f = vec2f(softness.x, softness.y) * 4096.0 * apart;
    let min_radius: f32 = softness.z * 0.0625;
    let max_radius: f32 = softness.w * 0.0625;
    return vec2f(select(min_radius, min(radius.x, max_radius), radius.x > min_radius),
                 select(min_radius, min(radius.y, max_radius), radius.y > min_radius));
}
