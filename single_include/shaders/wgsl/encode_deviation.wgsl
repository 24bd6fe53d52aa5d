// umbrage 0.1.0, MIT License: encode_deviation

// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
fn umbrage_encode_deviation(m: vec2f) -> vec2f {
    let variance: f32 = m.y - m.x * m.x;
    return vec2f(m.x, 2.0 * sqrt(select(0.0, variance, variance > 0.0)));
}
