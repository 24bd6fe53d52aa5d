// umbrage 0.1.0, MIT License: before_far

// umbrage_before_far: whether a receiver is a number, and not behind the far plane
fn umbrage_before_far(receiver: f32) -> bool {
    return receiver <= 1.0;
}
