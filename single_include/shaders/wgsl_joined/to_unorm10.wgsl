// umbrage 0.1.0, to_unorm10: value that makes a 10-bit target store channel 0..1023. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_to_unorm10: value that makes a 10-bit target store channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
fn umbrage_to_unorm10(k: f32) -> f32 {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec2f(k: vec2f) -> vec2f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec3f(k: vec3f) -> vec3f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec4f(k: vec4f) -> vec4f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
