// umbrage 0.1.0, reverse_depth: 1 - depth. Exactness: tier B.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_REVERSE_DEPTH
#define UMBRAGE_HAS_REVERSE_DEPTH
// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
inline float umbrage_reverse_depth(float depth) {
    return 1.0 - depth;
}
#endif
