// umbrage 0.1.0, fixed_ps14: number in a register of the Radeon 8500. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
fn umbrage_fixed_ps14(v: f32) -> f32 {
    let within: f32 = select(7.999755859375, v, v < 7.999755859375);
    let steps: f32 = select(-8.0, within, within > -8.0) * 4096.0;
    let below: f32 = floor(steps);
    return select(below + 1.0, below, steps - below < 0.5) * 0.000244140625;
}
