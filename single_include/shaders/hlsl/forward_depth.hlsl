// umbrage 0.1.0, forward_depth: depth that grows with distance. Exactness: tier B.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_FORWARD_DEPTH
#define UMBRAGE_HAS_FORWARD_DEPTH
// umbrage_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
float umbrage_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif
