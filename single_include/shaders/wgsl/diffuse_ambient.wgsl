// umbrage 0.1.0, MIT License: diffuse_ambient

// umbrage_diffuse_ambient: albedo * (visibility * max(n_dot_l, 0) * (1 - ambient) + ambient)
fn umbrage_diffuse_ambient(albedo: vec3f, ambient: f32, n_dot_l: f32, visibility: f32) -> vec3f {
    let facing: f32 = select(0.0, n_dot_l, n_dot_l > 0.0);
    let light: f32 = visibility * facing * (1.0 - ambient) + ambient;
    return albedo * light;
}
