// umbrage 0.1.0, MIT License: compare_exercise

// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
fn umbrage_compare_exercise(current: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(0.0, 1.0, current < limit);
}
