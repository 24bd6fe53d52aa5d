// umbrage 0.1.0, from_unorm16: channel 0..65535 of a value from a 16-bit texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
fn umbrage_from_unorm16(c: f32) -> f32 {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec2f(c: vec2f) -> vec2f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec3f(c: vec3f) -> vec3f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec4f(c: vec4f) -> vec4f {
    return floor(c * 65535.0 + 0.5);
}
