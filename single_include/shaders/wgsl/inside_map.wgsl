// umbrage 0.1.0, MIT License: inside_map

// umbrage_inside_map: whether a texel is one of a map's of size texels
fn umbrage_inside_map(size: vec2f, texel: vec2f) -> bool {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
