// umbrage 0.1.0, biased: receiver moved towards the light. Exactness: tier B.
// biased, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BIASED
#define UMBRAGE_HAS_BIASED
// umbrage_biased: receiver moved towards the light by bias, in depth; no move for NaN, or magnitudes of 2^64 or more
float umbrage_biased(float receiver, float bias) {
    float by = abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
#endif
