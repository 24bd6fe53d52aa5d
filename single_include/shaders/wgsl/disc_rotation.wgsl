// umbrage 0.1.0, disc_rotation: rotation of a disc for a pixel, one of 16. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, -sin, sin, cos) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
fn umbrage_disc_rotation(pixel: vec2f) -> vec4f {
    let whole: vec2f = select(vec2f(0.0, 0.0), floor(pixel), umbrage_inside_texel_space(pixel));
    var v: f32 = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    let quarter: f32 = floor(v * 0.25);
    let base: f32 = v - quarter * 4.0;
    let low: vec2f = select(vec2f(59.0, 24.0), vec2f(64.0, 0.0), base < 0.5);
    let high: vec2f = select(vec2f(24.0, 59.0), vec2f(45.0, 45.0), base < 2.5);
    let first: vec2f = select(high, low, base < 1.5);
    let once: vec2f = select(vec2f(0.0 - first.y, first.x), first, quarter < 0.5);
    let twice: vec2f = select(vec2f(first.y, 0.0 - first.x), vec2f(0.0 - first.x, 0.0 - first.y), quarter < 2.5);
    let turned: vec2f = select(twice, once, quarter < 1.5);
    return vec4f(turned.x, 0.0 - turned.y, turned.y, turned.x);
}
