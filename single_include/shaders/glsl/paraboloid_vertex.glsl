// umbrage 0.1.0, paraboloid_vertex: clip space position of a vertex in a paraboloid map. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// paraboloid_vertex, tier C: within 51 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_POSITION
#define UMBRAGE_HAS_DUAL_PARABOLOID_POSITION
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex
//   map        index of the map, 0.0 or 1.0
UMBRAGE_HIGHP vec4 umbrage_dual_paraboloid_position(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP float map) {
    bool behind = map > 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    UMBRAGE_HIGHP float distance_to = sqrt(square);
    UMBRAGE_HIGHP float w = distance_to + (behind ? -direction.z : direction.z);
    return vec4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
#endif

#ifndef UMBRAGE_HAS_PARABOLOID_VERTEX
#define UMBRAGE_HAS_PARABOLOID_VERTEX
// umbrage_paraboloid_vertex: clip space position of a vertex in a paraboloid map
//   to_clip    the light's projection
//   anchor     position of the light
//   number     0.0 or 1.0, the map
UMBRAGE_HIGHP vec4 umbrage_paraboloid_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world,
                                             UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP float number) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 p = umbrage_dual_paraboloid_position(way, number);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 place =
        to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
    return place;
}
#endif
