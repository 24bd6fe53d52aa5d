// umbrage 0.1.0, hausdorff_share: smallest fraction of nearer depths, for depths on [-1, 1]. Exactness: tier C.
// hausdorff_share, tier C: within 1/1048576 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_HAUSDORFF_SHARE
#define UMBRAGE_HAS_HAUSDORFF_SHARE
// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
float umbrage_hausdorff_share(float4 b, float z) {
    precise float variance = b.y - b.x * b.x;
    precise float third = b.z - b.x * b.y;
    precise float fourth = b.w - b.y * b.y;
    precise float rest = 1.0 - b.y;
    precise float x = z - b.x;
    precise float d = third + rest * x;
    precise float g = (fourth - variance * rest) - (z + b.x) * third;
    precise float p = d * (1.0 + b.x) + g;
    precise float q = d * (1.0 - b.x) - g;
    precise float k = rest * g + third * d;
    precise float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    precise float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    float square = d * d;
    precise float between = p * (q * (x * d - g));
    float end = first / (2.0 * ((1.0 + z) * p));
    float other = square * square / between;
    float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
#endif
