// umbrage 0.1.0, probe_color: debug color of a lookup: its texels, or why it fails. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_probe_color: debug color of a receiver's position in a map
//   at      x and y in texels, z depth
//   size    size of the map, in texels
//   bias    bias of the receiver, in depth
//   number  index of the map, an integer
//   magenta  not a number
//   black    behind the light
//   white    outside the map, or all cascades
//   cyan     beyond the far plane
//   blue     in front of the near plane
//   red      bias at its limit of 1.0
//   else     squares of one texel, gray or in the map's color: all is well
fn umbrage_probe_color(at: vec3f, size: vec2f, bias: f32, number: f32) -> vec3f {
    let limit: f32 = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    let usable: bool = abs(at.x) < limit && abs(at.y) * 2.0 < limit * 2.0 && abs(at.z) * 4.0 < limit * 4.0;
    let inside: bool = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    let forward: bool = umbrage_cleared_depth() > 0.5;
    let past_far: bool = select((at.z < 0.0), (at.z > 1.0), forward);
    let past_near: bool = select((at.z > 1.0), (at.z < 0.0), forward);
    let place: vec2f = clamp(vec2f(at.x, at.y), vec2f(0.0, 0.0), vec2f(65536.0, 65536.0));
    let square: f32 = floor(place.x) + floor(place.y);
    let shade: f32 = select(1.0, 0.75, square - 2.0 * floor(square * 0.5) > 0.5);
    var bits: vec3f = floor(vec3f(number, number * 0.5, number * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    var color: vec3f = (bits * 0.5 + 0.375) * shade;
    color = select(vec3f(1.0, 0.0, 0.0), color, bias < 1.0);
    color = select(color, vec3f(0.0, 0.0, 1.0), past_near);
    color = select(color, vec3f(0.0, 1.0, 1.0), past_far);
    color = select(vec3f(1.0, 1.0, 1.0), color, inside);
    color = select(vec3f(0.0, 0.0, 0.0), color, at.x < 65536.0);
    return select(vec3f(1.0, 0.0, 1.0), color, usable);
}
