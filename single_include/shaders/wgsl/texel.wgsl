// umbrage 0.1.0, MIT License: texel

// umbrage_texel: value of a texel inside the map; whole numbers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}
