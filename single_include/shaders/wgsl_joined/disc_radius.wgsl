// umbrage 0.1.0, disc_radius: radius of a disc, rounded down to 1/16 texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
fn umbrage_disc_radius(radius: f32) -> f32 {
    let inside: f32 = select(0.0, floor(radius * 16.0), radius > 0.0);
    return select(inside, 4095.0, radius >= 255.9375);
}
