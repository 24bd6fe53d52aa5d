// umbrage 0.1.0, MIT License: decode_threejs_legacy

#ifndef UMBRAGE_HAS_DECODE_THREEJS_LEGACY
#define UMBRAGE_HAS_DECODE_THREEJS_LEGACY
// umbrage_decode_threejs_legacy: the RGBA format of three.js r73 to r166, as sampled, to depth
float umbrage_decode_threejs_legacy(float4 c) {
    precise float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) + c.z * (255.0 / 65536.0) + c.w *
        (255.0 / 256.0);
    return depth;
}
#endif
