// umbrage 0.1.0, encode_deviation: two moments of depth (VSM) to mean and deviation. Exactness: tier C.
// encode_deviation, tier C: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_ENCODE_DEVIATION
#define UMBRAGE_HAS_ENCODE_DEVIATION
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
float2 umbrage_encode_deviation(float2 m) {
    precise float variance = m.y - m.x * m.x;
    return float2(m.x, 2.0 * sqrt(variance > 0.0 ? variance : 0.0));
}
#endif
