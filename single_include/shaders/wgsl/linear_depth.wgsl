// umbrage 0.1.0, MIT License: linear_depth

// umbrage_linear_depth: distance along the light's axis, positive in front of it, times 1 / z_far
fn umbrage_linear_depth(z_view: f32, inv_z_far: f32) -> f32 {
    return z_view * inv_z_far;
}
