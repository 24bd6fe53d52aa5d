// umbrage 0.1.0, cube_lit: one comparison with a texel of a cube map. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
fn umbrage_cube_face(direction: vec3f) -> f32 {
    let m: vec3f = abs(direction);
    let x: f32 = select(0.0, 1.0, direction.x < 0.0);
    let y: f32 = select(2.0, 3.0, direction.y < 0.0);
    let z: f32 = select(4.0, 5.0, direction.z < 0.0);
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return select(select(z, y, m.y >= m.z), select(z, x, m.x >= m.z), m.x >= m.y);
}

// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
fn umbrage_cube_plane(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_cube_face(direction);
    let x: vec3f = vec3f(select(direction.z, -direction.z, face < 0.5), -direction.y, face);
    let y: vec3f = vec3f(direction.x, select(-direction.z, direction.z, face < 2.5), face);
    let z: vec3f = vec3f(select(-direction.x, direction.x, face < 4.5), -direction.y, face);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}

// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
fn umbrage_cube_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(-p.z, -p.y, p.x), vec3f(p.z, -p.y, -p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}

// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
fn umbrage_cube_neighbor(texel: vec3f, size: f32) -> vec3f {
    let uv: vec2f = vec2f(texel.x, texel.y) * 2.0 + (1.0 - size);
    let beyond_u: bool = abs(uv.x) > size;
    let beyond_v: bool = abs(uv.y) > size;
    let m: f32 = select(size, size - 1.0, beyond_u || beyond_v);
    let p: vec3f = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3f(uv, m)));
    let inside: vec2f = (vec2f(p.x, p.y) + (size - 1.0)) * 0.5;
    return select(vec3f(inside, p.z), vec3f(0.0, 0.0, -1.0), beyond_u && beyond_v);
}

// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
fn umbrage_cube_tile(face: f32, size: f32) -> vec2f {
    let row: f32 = select(1.0, 0.0, face < 2.5);
    return vec2f((face - row * 3.0) * size, row * size);
}

// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}

// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, inside);
    let depth: f32 = value.x;
    return select(1.0, depth, inside.x == texel.x && inside.y == texel.y);
}

// umbrage_lit: visibility from one comparison with a texel
fn umbrage_lit(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}

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
