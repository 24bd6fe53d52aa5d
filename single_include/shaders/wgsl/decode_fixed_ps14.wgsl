// umbrage 0.1.0, decode_fixed_ps14: r / 8 + g in the Radeon 8500's fixed point. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
fn umbrage_fixed_ps14(v: f32) -> f32 {
    // not v < 8.0 ? v : ...: Mesa turns it into min, and softpipe's min gives NaN
    let within: f32 = select(select(7.999755859375, -8.0, v < 0.0), v, v > -8.0 && v < 7.999755859375);
    let steps: f32 = within * 4096.0;
    let below: f32 = floor(steps);
    return select(below + 1.0, below, steps - below < 0.5) * 0.000244140625;
}

// umbrage_decode_fixed_ps14: x / 2040 in steps of 1 / 4096 from the channels of an 11-bit code, as sampled
//   compare with umbrage_fixed_ps14(umbrage_receiver_ps14(depth)); 1.0 is not the far plane on this scale
fn umbrage_decode_fixed_ps14(c: vec2f) -> f32 {
    return floor(umbrage_fixed_ps14(c.x) * 512.0) * 0.000244140625 + umbrage_fixed_ps14(c.y);
}
