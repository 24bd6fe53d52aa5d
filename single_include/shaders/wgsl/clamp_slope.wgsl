// umbrage 0.1.0, clamp_slope: clamp of a slope to [-2, 2]; NaN becomes 2. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
fn umbrage_clamp_slope(slope: f32) -> f32 {
    return select(select(2.0, -2.0, slope <= -2.0), slope, abs(slope) < 2.0);
}
