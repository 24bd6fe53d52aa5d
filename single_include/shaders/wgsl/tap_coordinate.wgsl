// umbrage 0.1.0, MIT License: tap_coordinate

// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
fn umbrage_tap_coordinate(coordinate: vec4f, offset: vec2f) -> vec4f {
    let moved: vec2f = vec2f(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4f(moved.x, moved.y, coordinate.z, coordinate.w);
}
