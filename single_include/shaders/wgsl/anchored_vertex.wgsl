// umbrage 0.1.0, anchored_vertex: vertex of a depth pass in clip space, far from the origin too. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// anchored_vertex, tier B: within 20 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
fn umbrage_shadow_coordinate(m: mat4x4f, world: vec3f) -> vec4f {
    let c: vec4f = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}

// umbrage_anchored_vertex: clip space position of a vertex of a depth pass
//   to_clip, anchor   of a depth_view: anchor.xyz is subtracted from world, and anchor.w times w is added to z
fn umbrage_anchored_vertex(to_clip: mat4x4f, world: vec3f, anchor: vec4f) -> vec4f {
    let way: vec3f = world - vec3f(anchor.x, anchor.y, anchor.z);
    let c: vec4f = umbrage_shadow_coordinate(to_clip, way);
    let depth: f32 = c.z + anchor.w * c.w;
    return vec4f(c.x, c.y, depth, c.w);
}
