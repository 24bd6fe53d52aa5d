// umbrage 0.1.0, MIT License: cascade_coordinate

// umbrage_cascade_coordinate: a point, rotated into the light's directions, in a cascade's map: texels and depth
fn umbrage_cascade_coordinate(light: vec3f, scale: vec4f, offset: vec4f) -> vec3f {
    let start: vec3f = vec3f(offset.x, offset.y, offset.z);
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + start;
    return at;
}
