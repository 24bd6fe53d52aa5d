// umbrage 0.1.0, MIT License: floor_divide
// Paste along: mend_quotient.wgsl

// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
fn umbrage_floor_divide(a: f32, b: f32) -> f32 {
    return umbrage_mend_quotient(floor(a / b), a, b);
}
