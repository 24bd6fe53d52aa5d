// umbrage 0.1.0, to_unorm16: value that makes a 16-bit target store channel 0..65535. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_to_unorm16: value that makes a 16-bit target store channel k, whether it rounds or truncates
fn umbrage_to_unorm16(k: f32) -> f32 {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec2f(k: vec2f) -> vec2f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec2f(65536.0)) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec3f(k: vec3f) -> vec3f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec3f(65536.0)) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec4f(k: vec4f) -> vec4f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec4f(65536.0)) * (1.0 / 65536.0);
}
