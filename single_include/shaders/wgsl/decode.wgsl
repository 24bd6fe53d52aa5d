// umbrage 0.1.0, decode: depth of a texel's value. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_decode: depth of a texel's value
fn umbrage_decode(value: vec4f) -> f32 {
    return value.x;
}
