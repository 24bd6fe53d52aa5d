// umbrage 0.1.0, dithered_cascade: cascade of a pixel, or the next one, by its weight. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_dithered_cascade: index of a cascade, or of the next one if its weight is above the pixel's threshold
fn umbrage_dithered_cascade(number: f32, weight: f32, threshold: f32) -> f32 {
    return number + select(0.0, 1.0, weight > threshold);
}
