// umbrage 0.1.0, anchored_vertex: vertex of a depth pass in clip space, far from the origin too. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// anchored_vertex, tier B: within 20 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_SHADOW_COORDINATE
#define UMBRAGE_HAS_SHADOW_COORDINATE
// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
UMBRAGE_HIGHP vec4 umbrage_shadow_coordinate(UMBRAGE_HIGHP mat4 m, UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
#endif

#ifndef UMBRAGE_HAS_ANCHORED_VERTEX
#define UMBRAGE_HAS_ANCHORED_VERTEX
// umbrage_anchored_vertex: clip space position of a vertex of a depth pass
//   to_clip, anchor   of a depth_view: anchor.xyz is subtracted from world, and anchor.w times w is added to z
UMBRAGE_HIGHP vec4 umbrage_anchored_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world,
                                           UMBRAGE_HIGHP vec4 anchor) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 c = umbrage_shadow_coordinate(to_clip, way);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.z + anchor.w * c.w;
    return vec4(c.x, c.y, depth, c.w);
}
#endif
