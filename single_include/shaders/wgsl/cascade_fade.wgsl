// umbrage 0.1.0, MIT License: cascade_fade
// Paste along: cascade_weight.wgsl

// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis; depth * scale + offset
fn umbrage_cascade_fade(depth: f32, scale: f32, offset: f32) -> f32 {
    let v: f32 = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
