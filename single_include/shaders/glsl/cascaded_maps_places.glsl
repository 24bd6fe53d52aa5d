// umbrage 0.1.0, cascaded_maps_places: places of a point of the world in up to four cascades. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascaded_maps_places, tier C: within 38 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_EDGE
#define UMBRAGE_HAS_CASCADE_EDGE
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   coordinate   position in the cascade's map: texels, texels, depth
//   size, reach  size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], far from the map, and for NaN
UMBRAGE_HIGHP float umbrage_cascade_edge(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond =
        abs(vec2(coordinate.x, coordinate.y) - half_size) - (half_size - reach);
    bool near_map = beyond.x + beyond.y < 65536.0;  // false for NaN
    return coordinate.z >= 0.0 && coordinate.z <= 1.0 && near_map ? max(beyond.x, beyond.y) : 65536.0;
}
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

#ifndef UMBRAGE_HAS_CASCADED_MAPS_PLACES
#define UMBRAGE_HAS_CASCADED_MAPS_PLACES
// umbrage_cascaded_maps_places: places of a point of the world in one or two of up to four cascades
//   rotation          rotation from the world to the light's axes
//   scales, offsets   scales and offsets of the cascades
//   anchor            position that is subtracted from world
//   blending, terms   as for umbrage_cascade_pair, whose columns it returns; size of a map and reach of the filter
UMBRAGE_HIGHP mat4 umbrage_cascaded_maps_places(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec4 anchor,
                                                UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 light = rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec4 across =
        rotation[3] + rotation[0] * normal.x + rotation[1] * normal.y + rotation[2] * normal.z;
    UMBRAGE_HIGHP vec4 a = light * scales[0] + offsets[0];
    UMBRAGE_HIGHP vec4 b = light * scales[1] + offsets[1];
    UMBRAGE_HIGHP vec4 c = light * scales[2] + offsets[2];
    UMBRAGE_HIGHP vec4 d = light * scales[3] + offsets[3];
    UMBRAGE_HIGHP float edge_a = umbrage_cascade_edge(vec3(a.x, a.y, a.z), size, terms.z);
    UMBRAGE_HIGHP float edge_b = umbrage_cascade_edge(vec3(b.x, b.y, b.z), size, terms.z);
    UMBRAGE_HIGHP float edge_c = umbrage_cascade_edge(vec3(c.x, c.y, c.z), size, terms.z);
    UMBRAGE_HIGHP float edge_d = umbrage_cascade_edge(vec3(d.x, d.y, d.z), size, terms.z);
    bool in_a = edge_a <= 0.0;
    bool in_b = edge_b <= 0.0;
    bool in_c = edge_c <= 0.0;
    UMBRAGE_HIGHP vec4 none = vec4(65536.0, 65536.0, 0.0, 4.0);
    UMBRAGE_HIGHP vec4 found = edge_d <= 0.0 ? vec4(d.x, d.y, d.z, 3.0) : none;
    found = in_c ? vec4(c.x, c.y, c.z, 2.0) : found;
    found = in_b ? vec4(b.x, b.y, b.z, 1.0) : found;
    found = in_a ? vec4(a.x, a.y, a.z, 0.0) : found;
    // the next cascade is already looked at; no column is chosen by number
    UMBRAGE_HIGHP vec4 there = in_a ? b : (in_b ? c : d);
    UMBRAGE_HIGHP float edge = in_a ? edge_a : (in_b ? edge_b : (in_c ? edge_c : edge_d));
    UMBRAGE_HIGHP float next_edge = in_a ? edge_b : (in_b ? edge_c : edge_d);
    UMBRAGE_HIGHP vec4 scale = in_a ? scales[0] : (in_b ? scales[1] : (in_c ? scales[2] : scales[3]));
    UMBRAGE_HIGHP vec4 next_scale = in_a ? scales[1] : (in_b ? scales[2] : scales[3]);
    UMBRAGE_HIGHP float next_slack = in_a ? offsets[1].w : (in_b ? offsets[2].w : offsets[3].w);
    UMBRAGE_HIGHP float slack = in_a ? offsets[0].w : (in_b ? offsets[1].w : (in_c ? offsets[2].w : offsets[3].w));
    return umbrage_cascade_pair(vec3(across.x, across.y, across.z), found, vec3(there.x, there.y, there.z),
                                vec2(edge, next_edge), vec2(slack, next_slack), scale, next_scale, blending);
}
#endif
