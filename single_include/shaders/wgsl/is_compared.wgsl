// umbrage 0.1.0, MIT License: is_compared
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl

// umbrage_is_compared: whether a filter compares a receiver; outside texel space and beyond the far plane all is lit
fn umbrage_is_compared(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far(receiver));
}
