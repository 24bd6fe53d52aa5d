// umbrage 0.1.0, clamp_bias: clamp of a bias to [0, 1]; NaN becomes 1. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(1.0, select(0.0, bias, bias >= least), bias < 1.0);
}
