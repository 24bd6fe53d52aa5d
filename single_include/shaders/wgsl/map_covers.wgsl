// umbrage 0.1.0, map_covers: true if a receiver lies in a prefiltered map. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by outside.

// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
