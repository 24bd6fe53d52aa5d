// umbrage 0.1.0, MIT License: cleared_depth

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}
