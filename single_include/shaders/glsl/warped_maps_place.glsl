// umbrage 0.1.0, warped_maps_place: place of a point of the world in one of up to four warped cascades. Exactness:
//   tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// warped_maps_place, tier C: within 121 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_PLANE_IN_MAP
#define UMBRAGE_HAS_PLANE_IN_MAP
// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
UMBRAGE_HIGHP vec3 umbrage_plane_in_map(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                        UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    UMBRAGE_HIGHP vec4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y +
                           plane_matrix[2] * normal.z;
    return vec3(q.x, q.y, q.z);
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_SLOPE
#define UMBRAGE_HAS_RECEIVER_SLOPE
// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
UMBRAGE_HIGHP vec2 umbrage_receiver_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                          UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    UMBRAGE_HIGHP float depth = q.z == 0.0 ? 1.0e-30 : q.z;  // q is zero without a normal, and not where edge-on
    return vec2(-q.x / depth, -q.y / depth);
}
#endif

#ifndef UMBRAGE_HAS_ANCHORED_PLACE
#define UMBRAGE_HAS_ANCHORED_PLACE
// umbrage_anchored_place: place of a point in one map, and the slack of its plane
//   to_texels, planes   matrices from positions less the anchor to texels of the map, and to their planes
//   rounding, slack     of anchored_map; slack.w is added to depth
//   way                 position less the anchor
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack); behind the light: a place taken as lit
UMBRAGE_HIGHP mat4 umbrage_anchored_place(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes,
                                          UMBRAGE_HIGHP vec4 rounding, UMBRAGE_HIGHP vec4 slack,
                                          UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_HIGHP vec4 c = to_texels[3] + to_texels[0] * way.x + to_texels[1] * way.y + to_texels[2] * way.z;
    UMBRAGE_HIGHP vec2 slope = umbrage_receiver_slope(planes, normal, way);
    bool before = c.w > 0.0;
    UMBRAGE_HIGHP float i = before ? 1.0 / c.w : 0.0;
    UMBRAGE_HIGHP vec3 at = vec3(c.x, c.y, c.z) * i;
    UMBRAGE_HIGHP float steep = abs(slope.x) + abs(slope.y);
    UMBRAGE_HIGHP float moves = rounding.x + rounding.y * i;
    UMBRAGE_HIGHP float off = moves * (rounding.w + abs(at.z)) + (abs(at.z) * slack.y + slack.z);
    UMBRAGE_HIGHP float all = (moves * rounding.z + slack.x) * steep + off;
    return mat4(vec4(before ? at.x : 65536.0, at.y, at.z + slack.w, 0.0), vec4(slope, 1.0, all), none, none);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_COLUMN
#define UMBRAGE_HAS_CASCADE_COLUMN
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
UMBRAGE_HIGHP vec4 umbrage_cascade_column(UMBRAGE_HIGHP mat4 columns, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = number < 0.5 ? columns[0] : columns[1];
    UMBRAGE_HIGHP vec4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_WARPED_MAPS_PLACE
#define UMBRAGE_HAS_WARPED_MAPS_PLACE
// umbrage_warped_maps_place: place of a point of the world in one of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades, ahead              of umbrage_warped_maps_choice, not read
//   anchor                    the one anchor of all maps
//   ends                      w: number of the last cascade, after which the place is outside all maps, and lit
//   number                    number of the cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_warped_maps_place(UMBRAGE_HIGHP mat4 to_texels_0, UMBRAGE_HIGHP mat4 to_texels_1,
                                             UMBRAGE_HIGHP mat4 to_texels_2, UMBRAGE_HIGHP mat4 to_texels_3,
                                             UMBRAGE_HIGHP mat4 planes_0, UMBRAGE_HIGHP mat4 planes_1,
                                             UMBRAGE_HIGHP mat4 planes_2, UMBRAGE_HIGHP mat4 planes_3,
                                             UMBRAGE_HIGHP mat4 rounding, UMBRAGE_HIGHP mat4 slack,
                                             UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 anchor,
                                             UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends,
                                             UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec3 world,
                                             UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP float number) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP float own = min(number, ends.w);
    UMBRAGE_HIGHP mat4 to_texels = to_texels_0;
    UMBRAGE_HIGHP mat4 planes = planes_0;
    if (own > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
    }
    if (own > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
    }
    if (own > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    UMBRAGE_HIGHP mat4 at = umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, own),
                                                   umbrage_cascade_column(slack, own), way, normal);
    UMBRAGE_HIGHP float x = number <= ends.w ? at[0].x : -65536.0;
    return mat4(vec4(x, at[0].y, at[0].z, own), at[1], at[2], at[3]);
}
#endif
