// umbrage 0.1.0, disc_tap: texel that a point of a disc falls on. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     along x and y, in 1/16 texel, integers from 0 to 4095
fn umbrage_disc_tap(position: vec2f, p: vec2f, rotation: vec4f, radius: vec2f) -> vec2f {
    let at: vec2f = position * (1.0 / 256.0);
    let texel: vec2f = floor(at);
    let within: vec2f = clamp(at - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));  // no sum is regrouped across it
    let wide: vec2f = vec2f(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    let high: vec2f = vec2f(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    let x: f32 = wide.x * p.x + within.x + wide.y * p.y;
    let y: f32 = high.x * p.x + within.y + high.y * p.y;
    return texel + floor(vec2f(x, y));
}
