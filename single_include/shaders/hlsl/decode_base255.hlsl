// umbrage 0.1.0, MIT License: decode_base255

#ifndef UMBRAGE_HAS_DECODE_BASE255
#define UMBRAGE_HAS_DECODE_BASE255
// umbrage_decode_base255: base-255 RGBA, as sampled, to depth
float umbrage_decode_base255(float4 c) {
    precise float depth = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
#endif
