// umbrage 0.1.0, cascade_pair: places in a cascade and in the next one, with their weights. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_pair, tier C: within 14 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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

#ifndef UMBRAGE_HAS_CASCADE_SLOPE
#define UMBRAGE_HAS_CASCADE_SLOPE
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
UMBRAGE_HIGHP vec2 umbrage_cascade_slope(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec4 scale) {
    UMBRAGE_HIGHP vec2 up = vec2(normal.x, normal.y) * -scale.z;
    UMBRAGE_HIGHP float z = normal.z == 0.0 ? 1.0e-18 : normal.z;  // up is zero without a normal, and not where edge-on
    UMBRAGE_HIGHP vec2 across = vec2(scale.x, scale.y) * z;
    return vec2(up.x / across.x, up.y / across.y);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_PAIR
#define UMBRAGE_HAS_CASCADE_PAIR
// umbrage_cascade_pair: places in a cascade and in the next one, whose weight grows towards the border of the map
//   across                    normal, rotated into the light's axes
//   found                     (texels, texels, depth, index) in the cascade; an index above the last: in none
//   there                     (texels, texels, depth) in the next one
//   edges                     umbrage_cascade_edge of both
//   slacks                    w of the offsets of both: slack of a plane in depth
//   scale                     scale of the cascade; w: slack of a plane in texels of slope
//   next_scale                that of the next one
//   blending                  1.0 / width of the band in texels, or 0.0; index of the last cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack) of both. After the last: outside, lit
UMBRAGE_HIGHP mat4 umbrage_cascade_pair(UMBRAGE_HIGHP vec3 across, UMBRAGE_HIGHP vec4 found, UMBRAGE_HIGHP vec3 there,
                                        UMBRAGE_HIGHP vec2 edges, UMBRAGE_HIGHP vec2 slacks,
                                        UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 next_scale,
                                        UMBRAGE_HIGHP vec4 blending) {
    bool last = found.w >= blending.y;
    UMBRAGE_HIGHP vec2 v = edges * blending.x + 1.0;
    UMBRAGE_HIGHP float leaves = blending.x > 0.0 && found.w <= blending.y ? umbrage_cascade_weight(v.x) : 0.0;
    UMBRAGE_HIGHP float held = edges.y <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    UMBRAGE_HIGHP float weight = last ? leaves : min(leaves, held);
    UMBRAGE_HIGHP vec3 next = last ? vec3(-65536.0, -65536.0, 0.0) : there;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(across, scale);
    UMBRAGE_HIGHP vec2 next_slope = umbrage_cascade_slope(across, next_scale);
    UMBRAGE_HIGHP float slack = (abs(slope.x) + abs(slope.y)) * scale.w + slacks.x;
    UMBRAGE_HIGHP float next_slack = (abs(next_slope.x) + abs(next_slope.y)) * next_scale.w + slacks.y;
    return mat4(vec4(found.x, found.y, found.z, min(found.w, blending.y)), vec4(slope, 1.0, slack),
                vec4(next, min(found.w + 1.0, blending.y)), vec4(next_slope, weight, next_slack));
}
#endif
