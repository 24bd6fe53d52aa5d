// umbrage 0.1.0, blocker: count and distance code of one possible blocker. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
fn umbrage_texel_inside(size: vec2f, texel: vec2f) -> vec2f {
    return min(abs(texel), size - 1.0);
}

// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
fn umbrage_fetch_depth(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = umbrage_texel_inside(size, texel);
    let value: vec4f = umbrage_texel(map, size, inside);
    let depth: f32 = value.x;
    return select(1.0, depth, inside.x == texel.x && inside.y == texel.y);
}

// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
fn umbrage_distance_code(depth: f32) -> f32 {
    let v: f32 = depth * 65536.0;
    let forward: f32 = select(65535.0, floor(max(v, 0.0)), v < 65535.0);
    let reversed: f32 = select(0.0, floor(min(v, 65535.0)), v > 0.0);
    return select(65535.0 - reversed, forward, umbrage_cleared_depth() > 0.5);
}

// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
fn umbrage_blocker(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_fetch_depth(map, size, texel);
    let code: f32 = umbrage_distance_code(stored);
    return select(vec2f(1.0, code), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}
