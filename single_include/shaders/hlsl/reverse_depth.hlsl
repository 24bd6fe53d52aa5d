// umbrage 0.1.0, reverse_depth: 1 - depth. Exactness: tier B.
// reverse_depth, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_REVERSE_DEPTH
#define UMBRAGE_HAS_REVERSE_DEPTH
// umbrage_reverse_depth: forward depth from reversed depth, or reversed from forward
float umbrage_reverse_depth(float depth) {
    return 1.0 - depth;
}
#endif
