// umbrage 0.1.0, MIT License: distance_depth

// umbrage_distance_depth: length of to_point, from the light, times 1 / range
fn umbrage_distance_depth(to_point: vec3f, inv_range: f32) -> f32 {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
