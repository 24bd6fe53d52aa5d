// umbrage 0.1.0, decode_fixed_ps14: r / 8 + g in the Radeon 8500's fixed point. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_FIXED_PS14
#define UMBRAGE_HAS_FIXED_PS14
// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
float umbrage_fixed_ps14(float v) {
    // not v < 8.0 ? v : ...: Mesa turns it into min, and softpipe's min gives NaN
    float within = v > -8.0 && v < 7.999755859375 ? v : (v < 0.0 ? -8.0 : 7.999755859375);
    float steps = within * 4096.0;
    float below = floor(steps);
    return (steps - below < 0.5 ? below : below + 1.0) * 0.000244140625;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_FIXED_PS14
#define UMBRAGE_HAS_DECODE_FIXED_PS14
// umbrage_decode_fixed_ps14: x / 2040 in steps of 1 / 4096 from the channels of an 11-bit code, as sampled
//   compare with umbrage_fixed_ps14(umbrage_receiver_ps14(depth)); 1.0 is not the far plane on this scale
float umbrage_decode_fixed_ps14(float2 c) {
    return floor(umbrage_fixed_ps14(c.x) * 512.0) * 0.000244140625 + umbrage_fixed_ps14(c.y);
}
#endif
