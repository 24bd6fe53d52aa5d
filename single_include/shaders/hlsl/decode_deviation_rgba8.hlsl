// umbrage 0.1.0, decode_deviation_rgba8: mean and deviation in RGBA8 to two moments (VSM). Exactness: tier B.
// decode_deviation_rgba8, tier B: within 21 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_DECODE_DEVIATION
#define UMBRAGE_HAS_DECODE_DEVIATION
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
float2 umbrage_decode_deviation(float2 held) {
    float half_of_it = held.y * 0.5;
    precise float square = held.x * held.x + half_of_it * half_of_it;
    return float2(held.x, square);
}
#endif

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
float umbrage_from_unorm(float c) {
    return floor(c * 255.0 + 0.5);
}
float2 umbrage_from_unorm(float2 c) {
    return floor(c * 255.0 + 0.5);
}
float3 umbrage_from_unorm(float3 c) {
    return floor(c * 255.0 + 0.5);
}
float4 umbrage_from_unorm(float4 c) {
    return floor(c * 255.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG16
#define UMBRAGE_HAS_DECODE_RG16
// umbrage_decode_rg16: depth from the two channels of a 16-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg16(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_DEVIATION_RGBA8
#define UMBRAGE_HAS_DECODE_DEVIATION_RGBA8
// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
float2 umbrage_decode_deviation_rgba8(float4 c) {
    float mean = umbrage_decode_rg16(float2(c.x, c.y), 1.0);
    float deviation = umbrage_decode_rg16(float2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(float2(mean, deviation));
}
#endif
