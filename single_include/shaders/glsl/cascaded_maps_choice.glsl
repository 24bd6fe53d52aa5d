// umbrage 0.1.0, cascaded_maps_choice: those of up to four cascades that hold a point of the world. Exactness: tier
//   C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascaded_maps_choice, tier C: within 38 x 2^-23 x S of the exact result.
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
//   light          the point, rotated into the light's axes
//   scale, offset  those of the cascade
//   size, reach    size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], and for NaN there
UMBRAGE_HIGHP float umbrage_cascade_edge(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale, UMBRAGE_HIGHP vec4 offset,
                                         UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + vec3(offset.x, offset.y, offset.z);
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_HIGHP vec2 beyond = abs(vec2(at.x, at.y) - half_size) - (half_size - reach);
    return abs(at.z - 0.5) <= 0.5 ? max(beyond.x, beyond.y) : 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_EDGES
#define UMBRAGE_HAS_CASCADE_EDGES
// umbrage_cascade_edges: umbrage_cascade_edge of four cascades
//   scales, offsets   one column per cascade
UMBRAGE_HIGHP vec4 umbrage_cascade_edges(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                         UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP float reach) {
    return vec4(umbrage_cascade_edge(light, scales[0], offsets[0], size, reach),
                umbrage_cascade_edge(light, scales[1], offsets[1], size, reach),
                umbrage_cascade_edge(light, scales[2], offsets[2], size, reach),
                umbrage_cascade_edge(light, scales[3], offsets[3], size, reach));
}
#endif

#ifndef UMBRAGE_HAS_FIRST_CASCADE
#define UMBRAGE_HAS_FIRST_CASCADE
// umbrage_first_cascade: number of the first of four cascades that holds a point and its filter, its edge, and the edge
// of the next one; (4.0, 65536.0, 65536.0) for none
//   edges   umbrage_cascade_edge of each
UMBRAGE_HIGHP vec3 umbrage_first_cascade(UMBRAGE_HIGHP vec4 edges) {
    UMBRAGE_HIGHP vec3 found = edges.w <= 0.0 ? vec3(3.0, edges.w, 65536.0) : vec3(4.0, 65536.0, 65536.0);
    found = edges.z <= 0.0 ? vec3(2.0, edges.z, edges.w) : found;
    found = edges.y <= 0.0 ? vec3(1.0, edges.y, edges.z) : found;
    return edges.x <= 0.0 ? vec3(0.0, edges.x, edges.y) : found;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_NEXT_CASCADE_WEIGHT
#define UMBRAGE_HAS_NEXT_CASCADE_WEIGHT
// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
UMBRAGE_HIGHP float umbrage_next_cascade_weight(UMBRAGE_HIGHP vec3 found, UMBRAGE_HIGHP vec4 blending) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 v = vec2(found.y, found.z) * blending.x + 1.0;
    UMBRAGE_HIGHP float leaves = umbrage_cascade_weight(v.x);
    UMBRAGE_HIGHP float held = found.z <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    UMBRAGE_HIGHP float weight = found.x >= blending.y ? leaves : min(leaves, held);
    return blending.x > 0.0 && found.x <= blending.y ? weight : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADED_MAPS_CHOICE
#define UMBRAGE_HAS_CASCADED_MAPS_CHOICE
// umbrage_cascaded_maps_choice: number of the first of up to four cascades that holds a point, and weight of the next
//   rotation          rotation from the world to the light's axes
//   scales, offsets   scales and offsets of the cascades
//   anchor            position that is subtracted from world
//   blending, terms   as for umbrage_next_cascade_weight; size of a map and reach of the filter
UMBRAGE_HIGHP vec2 umbrage_cascaded_maps_choice(UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales,
                                                UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec4 anchor,
                                                UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms,
                                                UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 turned =
        rotation[3] + rotation[0] * way.x + rotation[1] * way.y + rotation[2] * way.z;
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 found = umbrage_first_cascade(umbrage_cascade_edges(light, scales, offsets, size, terms.z));
    return vec2(found.x, umbrage_next_cascade_weight(found, blending));
}
#endif
