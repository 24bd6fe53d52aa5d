// umbrage 0.1.0, MIT License: decode_threejs_rg

#ifndef UMBRAGE_HAS_DECODE_THREEJS_RG
#define UMBRAGE_HAS_DECODE_THREEJS_RG
// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
float umbrage_decode_threejs_rg(float2 c) {
    precise float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
#endif
