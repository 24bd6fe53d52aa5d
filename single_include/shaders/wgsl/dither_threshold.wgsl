// umbrage 0.1.0, dither_threshold: one of 16 dither thresholds for a pixel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_dither_threshold: dither threshold of a position in pixels: 1/32 to 31/32, each once in 4x4 pixels
fn umbrage_dither_threshold(pixel: vec2f) -> f32 {
    let whole: vec2f = select(vec2f(0.0, 0.0), floor(pixel), umbrage_inside_texel_space(pixel));
    let high: vec2f = floor(whole * 0.5);
    let above: vec2f = floor(whole * 0.25);
    let b0: vec2f = whole - high * 2.0;
    let b1: vec2f = high - above * 2.0;
    let m: f32 = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
