// umbrage 0.1.0, cascade_coordinate: position of a point in one cascade's map. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// cascade_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
fn umbrage_cascade_coordinate(light: vec3f, scale: vec4f, offset: vec4f) -> vec3f {
    let start: vec3f = vec3f(offset.x, offset.y, offset.z);
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + start;
    return at;
}
