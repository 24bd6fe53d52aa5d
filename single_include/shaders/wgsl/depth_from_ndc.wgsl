// umbrage 0.1.0, MIT License: depth_from_ndc

// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
fn umbrage_depth_from_ndc(ndc: f32) -> f32 {
    let depth: f32 = ndc * 0.5 + 0.5;
    return depth;
}
