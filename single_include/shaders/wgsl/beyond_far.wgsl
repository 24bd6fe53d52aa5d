// umbrage 0.1.0, MIT License: beyond_far

// umbrage_beyond_far: whether a receiver is behind the far plane
fn umbrage_beyond_far(receiver: f32) -> bool {
    return receiver > 1.0;
}
