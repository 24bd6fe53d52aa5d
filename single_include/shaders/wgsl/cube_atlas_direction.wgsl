// umbrage 0.1.0, cube_atlas_direction: direction that reads an atlas texel from a cube texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
fn umbrage_cube_atlas_texel(texel: vec2f, size: f32) -> vec3f {
    let column: f32 = select(select(2.0, 1.0, texel.x < size * 2.0), 0.0, texel.x < size);
    let row: f32 = select(1.0, 0.0, texel.y < size);
    return vec3f(texel - vec2f(column, row) * size, column + row * 3.0);
}

// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
fn umbrage_cube_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(-p.z, -p.y, p.x), vec3f(p.z, -p.y, -p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}

// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
fn umbrage_cube_atlas_direction(texel: vec2f, size: f32) -> vec3f {
    let part: vec3f = umbrage_cube_atlas_texel(texel, size);
    let uv: vec2f = vec2f(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3f(uv, size));
}
