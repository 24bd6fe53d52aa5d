// umbrage 0.1.0, cube_atlas_direction: direction that reads an atlas texel from a cube texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cube_atlas_texel.wgsl, cube_point.wgsl; or paste wgsl_joined/cube_atlas_direction.wgsl alone.

// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
fn umbrage_cube_atlas_direction(texel: vec2f, size: f32) -> vec3f {
    let part: vec3f = umbrage_cube_atlas_texel(texel, size);
    let uv: vec2f = vec2f(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3f(uv, size));
}
