// umbrage 0.1.0, MIT License: tetrahedron_view_z
// Paste along: tetrahedron_face.wgsl, tetrahedron_plane.wgsl

// umbrage_tetrahedron_view_z: distance along the face's normal, of which per-face depths are made
fn umbrage_tetrahedron_view_z(direction: vec3f) -> f32 {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let z: f32 = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
