// umbrage 0.1.0, hardened_kernel8: fraction of a disc in shadow, steepened. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_hardened_kernel8: fraction of 8 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
fn umbrage_hardened_kernel8(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 8.0;
    let d: f32 = max(8.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 512.0 - d * d * d;
    let hard: f32 = select(512.0 + steep, 512.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
