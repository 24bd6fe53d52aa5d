// umbrage 0.1.0, MIT License: cube_atlas_texel

// umbrage_cube_atlas_texel: (s, t, face) of a texel of an atlas of 3 x 2 tiles of size texels; whole numbers
fn umbrage_cube_atlas_texel(texel: vec2f, size: f32) -> vec3f {
    let column: f32 = select(select(2.0, 1.0, texel.x < size * 2.0), 0.0, texel.x < size);
    let row: f32 = select(1.0, 0.0, texel.y < size);
    return vec3f(texel - vec2f(column, row) * size, column + row * 3.0);
}
