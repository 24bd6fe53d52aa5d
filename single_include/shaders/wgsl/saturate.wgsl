// umbrage 0.1.0, saturate: clamp to [0, 1]; NaN becomes the far plane. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
fn umbrage_saturate(v: f32) -> f32 {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return select(select(select(umbrage_cleared_depth(), 0.0, v <= 0.0), 1.0, v >= 1.0), v, v > 0.0 && v < 1.0);
}
