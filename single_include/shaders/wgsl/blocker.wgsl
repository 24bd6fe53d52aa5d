// umbrage 0.1.0, MIT License: blocker
// Paste along: texel.wgsl, fetch_clamped.wgsl, decode.wgsl, fetch_depth.wgsl, compare.wgsl, cleared_depth.wgsl, distance_code.wgsl

// umbrage_blocker: (1.0, umbrage_distance_code) of a texel before the receiver, of any other (0.0, 0.0)
fn umbrage_blocker(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_fetch_depth(map, size, texel);
    let code: f32 = umbrage_distance_code(stored);
    return select(vec2f(1.0, code), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}
