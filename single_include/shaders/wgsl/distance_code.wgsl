// umbrage 0.1.0, distance_code: distance of a depth from the near plane, 16 bits. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
fn umbrage_distance_code(depth: f32) -> f32 {
    let v: f32 = depth * 65536.0;
    let forward: f32 = select(65535.0, floor(max(v, 0.0)), v < 65535.0);
    let reversed: f32 = select(0.0, floor(min(v, 65535.0)), v > 0.0);
    return select(65535.0 - reversed, forward, umbrage_cleared_depth() > 0.5);
}
