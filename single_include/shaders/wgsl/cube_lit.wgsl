// umbrage 0.1.0, MIT License: cube_lit
// Paste along: cube_face.wgsl, cube_plane.wgsl, cube_point.wgsl, cube_neighbour.wgsl, cube_tile.wgsl, compare.wgsl, texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, lit.wgsl

// umbrage_cube_lit: (visibility of one comparison, 1.0) with a texel of a cube, (0.0, 0.0) beyond a corner
//   map, size  atlas of 3 x 2 faces and its size in texels;   texel  (s, t, face), whole numbers
fn umbrage_cube_lit(map: texture_2d<f32>, size: vec2f, texel: vec3f, receiver: f32) -> vec2f {
    let side: f32 = size.y * 0.5;
    let n: vec3f = umbrage_cube_neighbour(texel, side);
    let at: vec2f = umbrage_cube_tile(n.z, side) + vec2f(n.x, n.y);
    let lit: f32 = umbrage_lit(map, size, at, receiver);
    return select(vec2f(lit, 1.0), vec2f(0.0, 0.0), n.z < 0.0);
}
