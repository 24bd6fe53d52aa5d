// umbrage 0.1.0, hardened_kernel32: fraction of a disc in shadow, steepened. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_hardened_kernel32: fraction of 32 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
fn umbrage_hardened_kernel32(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 32.0;
    let d: f32 = max(32.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 32768.0 - d * d * d;
    let hard: f32 = select(32768.0 + steep, 32768.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
