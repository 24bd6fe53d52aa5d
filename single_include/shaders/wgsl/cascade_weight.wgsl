// umbrage 0.1.0, cascade_weight: weight in steps of 1/256. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    return select(0.0, min(floor(v * 256.0), 256.0) * (1.0 / 256.0), v > 0.0);
}
