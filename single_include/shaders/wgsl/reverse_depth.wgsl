// umbrage 0.1.0, MIT License: reverse_depth

// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
fn umbrage_reverse_depth(depth: f32) -> f32 {
    return 1.0 - depth;
}
