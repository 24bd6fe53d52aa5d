// umbrage 0.1.0, MIT License: forward_depth
// Paste along: cleared_depth.wgsl

// umbrage_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
fn umbrage_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}
