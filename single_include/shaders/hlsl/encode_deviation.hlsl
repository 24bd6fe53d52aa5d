// umbrage 0.1.0, encode_deviation: depth's two moments to mean and deviation. Exactness: tier C.
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
