// umbrage 0.1.0, MIT License: power_of_two

// umbrage_power_of_two: 2^n of a whole number n, -64.0 to 63.0
fn umbrage_power_of_two(n: f32) -> f32 {
    let exponent: u32 = u32(n + 127.0);
    return bitcast<f32>(exponent << 23);
}
