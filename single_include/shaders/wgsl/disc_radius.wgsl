// umbrage 0.1.0, MIT License: disc_radius

// umbrage_disc_radius: a disc's radius in 1/16 texel, from one in texels: a whole number from 0 to 4095, of a NaN 0
fn umbrage_disc_radius(radius: f32) -> f32 {
    let inside: f32 = select(0.0, floor(radius * 16.0), radius > 0.0);
    return select(inside, 4095.0, radius >= 255.9375);
}
