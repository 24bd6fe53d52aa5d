// umbrage 0.1.0, MIT License: decode_ps14

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DECODE_PS14
#define UMBRAGE_HAS_DECODE_PS14
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14;
//   1.0 is not the far plane on this scale
inline float umbrage_decode_ps14(float2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
#endif
