// umbrage 0.1.0, summed_variance: variance shadow over a box of any size, from a SAT. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// summed_variance, tier C: within 1/65536 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture, outside, direction.

// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}

// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
fn umbrage_correct_quotient(q: f32, a: f32, b: f32) -> f32 {
    let more: f32 = q + 1.0;
    let known: f32 = select(q, more, more * b <= a);
    return select(known, q - 1.0, q * b > a);
}

// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
fn umbrage_floor_divide(a: f32, b: f32) -> f32 {
    return umbrage_correct_quotient(floor(a / b), a, b);
}

// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}

// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}

// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
fn umbrage_texel(map: texture_2d<f32>, size: vec2f, texel: vec2f) -> vec4f {
    return textureLoad(map, vec2i(texel), 0);
}

// umbrage_box_moments: (mean, rest, high, low) of the quantized depths in a box of n texels, integers
//   The sum of the depths is n mean + rest. The sum of their squared distances from mean is 4096 high + low
//   map, size    table from make_variance_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
fn umbrage_box_moments(map: texture_2d<f32>, size: vec2f, first: vec2f, end: vec2f) -> vec4f {
    let a: vec4f = umbrage_texel(map, size, end);
    let b: vec4f = umbrage_texel(map, size, vec2f(first.x, end.y));
    let c: vec4f = umbrage_texel(map, size, vec2f(end.x, first.y));
    let d: vec4f = umbrage_texel(map, size, first);
    let part: vec4f = (a - b) - (c - d);
    var low: vec2f = vec2f(part.x, part.z);
    let carry: vec2f = floor(low * (1.0 / 65536.0));
    var above: vec2f = vec2f(part.y, part.w) + carry;
    // nothing below is negative. The maxima keep compilers from regrouping sums across them
    low = max(low - carry * 65536.0, vec2f(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, vec2f(0.0, 0.0));
    let sum: f32 = above.x * 65536.0 + low.x;
    let sides: vec2f = max(end - first, vec2f(1.0, 1.0));
    let n: f32 = sides.x * sides.y;
    let mean: f32 = umbrage_floor_divide(sum, n);
    let rest: f32 = max(sum - mean * n, 0.0);
    var digits: vec2f = vec2f(sum + rest, low.y);
    let high: vec2f = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, vec2f(0.0, 0.0));
    let below: f32 = digits.y - mean * digits.x;
    let borrow: f32 = floor(below * (1.0 / 4096.0));
    var wide: f32 = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return vec4f(mean, rest, wide, below - borrow * 4096.0);
}

// umbrage_summed_variance: variance shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_variance_table and its size: the shadow map's plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   codes       2^bits of the table
fn umbrage_summed_variance(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           codes: f32) -> f32 {
    let last: vec2f = size - 1.0;
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(last, coord));
    let texel: vec2f = select(vec2f(0.0, 0.0), clamp(floor(coord), vec2f(0.0, 0.0), last - 1.0), compared);
    let first: vec2f = max(texel - radius, vec2f(0.0, 0.0));
    let end: vec2f = min(texel + radius + 1.0, last);
    let m: vec4f = umbrage_box_moments(map, size, first, end);
    let sides: vec2f = end - first;
    let n: f32 = sides.x * sides.y;
    let share: f32 = m.y / n;
    let variance: f32 = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    let scaled: f32 = receiver * codes;
    let t: f32 = select(codes - scaled, scaled, umbrage_cleared_depth() > 0.5);
    let d: f32 = (t - 1.0 - m.x) - share;
    let behind: f32 = select(0.0, variance / (variance + d * d), d > 0.0);
    return select(1.0, select(behind, 1.0, d <= 0.0), compared);
}
