// umbrage 0.1.0, to_unorm: value that makes an 8-bit target store channel 0..255. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_to_unorm: value that makes an 8-bit target store channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536, in decimals because 65536.0 is infinite in mediump
fn umbrage_to_unorm(k: f32) -> f32 {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec2f(k: vec2f) -> vec2f {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec3f(k: vec3f) -> vec3f {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec4f(k: vec4f) -> vec4f {
    return k * 0.0039215087890625 + 0.0009765625;
}
