// umbrage 0.1.0, warped_maps_places: places of a point of the world in up to four warped cascades. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// warped_maps_places, tier C: within 121 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_BY_DEPTH
#define UMBRAGE_HAS_CASCADE_BY_DEPTH
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
UMBRAGE_HIGHP float umbrage_cascade_by_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec3 ends) {
    UMBRAGE_HIGHP int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
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

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_FADE
#define UMBRAGE_HAS_CASCADE_FADE
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
UMBRAGE_HIGHP float umbrage_cascade_fade(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float scale,
                                         UMBRAGE_HIGHP float offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
#endif

#ifndef UMBRAGE_HAS_WARPED_MAPS_PLACES
#define UMBRAGE_HAS_WARPED_MAPS_PLACES
// umbrage_warped_maps_places: places of a point of the world in one or two of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades                     one column per map: scale and offset of the next one's weight
//   anchor                    the one anchor of all maps
//   ahead                     distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends                      ends of the first three cascades, number of the last one
//   returns (texels, texels, depth, number), (slope, slope, weight, slack) of both. After the last: outside, lit
UMBRAGE_HIGHP mat4 umbrage_warped_maps_places(UMBRAGE_HIGHP mat4 to_texels_0, UMBRAGE_HIGHP mat4 to_texels_1,
                                              UMBRAGE_HIGHP mat4 to_texels_2, UMBRAGE_HIGHP mat4 to_texels_3,
                                              UMBRAGE_HIGHP mat4 planes_0, UMBRAGE_HIGHP mat4 planes_1,
                                              UMBRAGE_HIGHP mat4 planes_2, UMBRAGE_HIGHP mat4 planes_3,
                                              UMBRAGE_HIGHP mat4 rounding, UMBRAGE_HIGHP mat4 slack,
                                              UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 anchor,
                                              UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends,
                                              UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec3 world,
                                              UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    UMBRAGE_HIGHP float number = umbrage_cascade_by_depth(depth, vec3(ends.x, ends.y, ends.z));
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(fades, number);
    UMBRAGE_HIGHP float weight = umbrage_cascade_fade(depth, own.x, own.y);
    UMBRAGE_HIGHP mat4 to_texels = to_texels_0;
    UMBRAGE_HIGHP mat4 planes = planes_0;
    UMBRAGE_HIGHP mat4 to_next = to_texels_1;
    UMBRAGE_HIGHP mat4 next_planes = planes_1;
    if (number > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
        to_next = to_texels_2;
        next_planes = planes_2;
    }
    if (number > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
        to_next = to_texels_3;
        next_planes = planes_3;
    }
    if (number > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    UMBRAGE_HIGHP mat4 at = umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, number),
                                                   umbrage_cascade_column(slack, number), way, normal);
    UMBRAGE_HIGHP mat4 there =
        umbrage_anchored_place(to_next, next_planes, umbrage_cascade_column(rounding, number + 1.0),
                               umbrage_cascade_column(slack, number + 1.0), way, normal);
    UMBRAGE_HIGHP vec3 after = vec3(there[0].x, there[0].y, there[0].z);
    UMBRAGE_HIGHP vec3 next = number >= ends.w ? vec3(-65536.0, -65536.0, 0.0) : after;
    return mat4(vec4(at[0].x, at[0].y, at[0].z, number), at[1], vec4(next, min(number + 1.0, ends.w)),
                vec4(there[1].x, there[1].y, weight, there[1].w));
}
#endif
