// umbrage 0.1.0, from_optimized_moments: four 16-bit channels to four moments (MSM). Exactness: tier B.
// from_optimized_moments, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
#define UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
float4 umbrage_from_optimized_moments(float4 o) {
    precise float x = o.x - 0.5;
    precise float z = o.z - 0.5;
    float eighth = o.y * 0.125;
    precise float b1 = z * 1.73205078 - x * 0.333333343;
    precise float b2 = o.w + eighth;
    precise float b3 = z * 1.29903817 - x * 0.75;
    precise float b4 = o.w - eighth;
    return float4(b1, b2, b3, b4);
}
#endif
