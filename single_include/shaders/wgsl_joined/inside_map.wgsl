// umbrage 0.1.0, inside_map: true if a texel lies inside the map. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_inside_map: true if a texel lies inside a map of size texels
fn umbrage_inside_map(size: vec2f, texel: vec2f) -> bool {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
