// umbrage 0.1.0, MIT License: compare_dx_sdk

// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
fn umbrage_compare_dx_sdk(receiver: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(1.0, 0.0, limit < receiver);
}
