// umbrage 0.1.0, summed_variance: variance shadow over a box of any size, from a SAT. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// summed_variance, tier C: within 1/65536 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, texels of the kind that the function's comment names, read unfiltered.
// Other maps: bind() of the library or of its npm package prints this text, by texture, outside, direction.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
#endif

#ifndef UMBRAGE_HAS_CORRECT_QUOTIENT
#define UMBRAGE_HAS_CORRECT_QUOTIENT
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
UMBRAGE_HIGHP float umbrage_correct_quotient(UMBRAGE_HIGHP float q, UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    UMBRAGE_HIGHP float more = q + 1.0;
    UMBRAGE_HIGHP float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
#endif

#ifndef UMBRAGE_HAS_FLOOR_DIVIDE
#define UMBRAGE_HAS_FLOOR_DIVIDE
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
UMBRAGE_HIGHP float umbrage_floor_divide(UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
bool umbrage_in_filter_domain(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
bool umbrage_map_covers(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(texel), 0);
#else
    return texture2D(map, (texel + 0.5) / size);
#endif
}
#endif

#ifndef UMBRAGE_HAS_BOX_MOMENTS
#define UMBRAGE_HAS_BOX_MOMENTS
// umbrage_box_moments: (mean, rest, high, low) of the quantized depths in a box of n texels, integers
//   The sum of the depths is n mean + rest. The sum of their squared distances from mean is 4096 high + low
//   map, size    table from make_variance_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
UMBRAGE_HIGHP vec4 umbrage_box_moments(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                       UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 part = (a - b) - (c - d);
    UMBRAGE_HIGHP vec2 low = vec2(part.x, part.z);
    UMBRAGE_HIGHP vec2 carry = floor(low * (1.0 / 65536.0));
    UMBRAGE_HIGHP vec2 above = vec2(part.y, part.w) + carry;
    // nothing below is negative. The maxima keep compilers from regrouping sums across them
    low = max(low - carry * 65536.0, vec2(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP float sum = above.x * 65536.0 + low.x;
    UMBRAGE_HIGHP vec2 sides = max(end - first, vec2(1.0, 1.0));
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(sum, n);
    UMBRAGE_HIGHP float rest = max(sum - mean * n, 0.0);
    UMBRAGE_HIGHP vec2 digits = vec2(sum + rest, low.y);
    UMBRAGE_HIGHP vec2 high = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP float below = digits.y - mean * digits.x;
    UMBRAGE_HIGHP float borrow = floor(below * (1.0 / 4096.0));
    UMBRAGE_HIGHP float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return vec4(mean, rest, wide, below - borrow * 4096.0);
}
#endif

#ifndef UMBRAGE_HAS_SUMMED_VARIANCE
#define UMBRAGE_HAS_SUMMED_VARIANCE
// umbrage_summed_variance: variance shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_variance_table and its size: the shadow map's plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   codes       2^bits of the table
UMBRAGE_HIGHP float umbrage_summed_variance(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                            UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                            UMBRAGE_HIGHP float radius, UMBRAGE_HIGHP float codes) {
    UMBRAGE_HIGHP vec2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec2 texel = compared ? clamp(floor(coord), vec2(0.0, 0.0), last - 1.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 first = max(texel - radius, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 end = min(texel + radius + 1.0, last);
    UMBRAGE_HIGHP vec4 m = umbrage_box_moments(map, size, first, end);
    UMBRAGE_HIGHP vec2 sides = end - first;
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float share = m.y / n;
    UMBRAGE_HIGHP float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    UMBRAGE_HIGHP float scaled = receiver * codes;
    UMBRAGE_HIGHP float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    UMBRAGE_HIGHP float d = (t - 1.0 - m.x) - share;
    UMBRAGE_HIGHP float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
#endif
