// umbrage 0.1.0, MIT License: decode_threejs_rgb

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DECODE_THREEJS_RGB
#define UMBRAGE_HAS_DECODE_THREEJS_RGB
// umbrage_decode_threejs_rgb: the RGB format of three.js r167 and later, as sampled, to depth
inline float umbrage_decode_threejs_rgb(float3 c) {
    float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
#endif
