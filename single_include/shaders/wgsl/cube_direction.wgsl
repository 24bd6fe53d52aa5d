// umbrage 0.1.0, MIT License: cube_direction

// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
fn umbrage_cube_direction(face: f32, st: vec2f) -> vec3f {
    let u: f32 = st.x * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    let v: f32 = st.y * 2.0 - 1.0;
    let x: vec3f = select(vec3f(-1.0, -v, u), vec3f(1.0, -v, -u), face < 0.5);
    let y: vec3f = select(vec3f(u, -1.0, -v), vec3f(u, 1.0, v), face < 2.5);
    let z: vec3f = select(vec3f(-u, -v, -1.0), vec3f(u, -v, 1.0), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
