// umbrage 0.1.0, MIT License: project_depth

// umbrage_project_depth: z / w; for w <= 0.0 cleared, which is 1.0, or 0.0 when reversed
fn umbrage_project_depth(z: f32, w: f32, cleared: f32) -> f32 {
    return select(cleared, z / w, w > 0.0);
}
