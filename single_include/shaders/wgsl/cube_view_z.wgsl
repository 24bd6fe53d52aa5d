// umbrage 0.1.0, MIT License: cube_view_z
// Paste along: cube_face.wgsl

// umbrage_cube_view_z: the greatest component's magnitude, of which per-face depths are made
fn umbrage_cube_view_z(direction: vec3f) -> f32 {
    let face: f32 = umbrage_cube_face(direction);
    let side: f32 = select(direction.y, direction.x, face < 1.5);
    return abs(select(side, direction.z, face > 3.5));
}
