// umbrage 0.1.0, MIT License: distance_code
// Paste along: cleared_depth.wgsl, saturate.wgsl

// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
fn umbrage_distance_code(depth: f32) -> f32 {
    let code: f32 = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    return select(65535.0 - code, code, umbrage_cleared_depth() > 0.5);
}
