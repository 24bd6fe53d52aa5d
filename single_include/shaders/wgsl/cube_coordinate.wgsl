// umbrage 0.1.0, MIT License: cube_coordinate
// Paste along: cube_face.wgsl

// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
fn umbrage_cube_coordinate(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_cube_face(direction);
    let on_x: bool = face < 1.5;
    let on_y: bool = face > 1.5 && face < 3.5;
    let along: f32 = select(select(direction.z, direction.y, on_y), direction.x, on_x);
    let m: f32 = abs(along);
    let z: f32 = select(direction.z, -direction.z, along < 0.0);
    let x: f32 = select(direction.x, -direction.x, along < 0.0);
    let sc: f32 = select(select(x, direction.x, on_y), -z, on_x);
    let tc: f32 = select(-direction.y, z, on_y);
    return vec3f((sc + m) / (m + m), (tc + m) / (m + m), face);
}
