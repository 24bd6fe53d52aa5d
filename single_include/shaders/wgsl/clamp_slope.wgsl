// umbrage 0.1.0, MIT License: clamp_slope

// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
fn umbrage_clamp_slope(slope: f32) -> f32 {
    return select(select(2.0, -2.0, slope <= -2.0), slope, slope > -2.0 && slope < 2.0);
}
