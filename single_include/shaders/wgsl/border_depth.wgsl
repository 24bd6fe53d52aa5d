// umbrage 0.1.0, border_depth: what texels outside the map count as, the far plane. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Paste along: cleared_depth.wgsl; or paste wgsl_joined/border_depth.wgsl alone.

// umbrage_border_depth: what texels outside the map count as, the far plane
fn umbrage_border_depth() -> f32 {
    return umbrage_cleared_depth();
}
