// umbrage 0.1.0, MIT License: tetrahedron_coordinate
// Paste along: tetrahedron_face.wgsl, tetrahedron_plane.wgsl

// umbrage_tetrahedron_coordinate: (s, t, face) of a direction: -1.0 to 1.0 along the base, 0.0 at it to 1.0 at the apex
fn umbrage_tetrahedron_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let d: f32 = p.z * 2.0 + p.y * -1.414213562;
    return vec3f(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
