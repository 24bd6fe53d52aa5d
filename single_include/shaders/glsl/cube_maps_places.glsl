// umbrage 0.1.0, cube_maps_places: place of a point of the world in a cube's six maps. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cube_maps_places, tier C: within 121 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CUBE_MAPS_PLACES
#define UMBRAGE_HAS_CUBE_MAPS_PLACES
// umbrage_cube_maps_places: place of a point of the world in a cube's six maps
//   face              texels a unit across the face's axis, at distance 1 along it; middle of a map; depth over
//                     1.0 / distance, and that by texels
//   anchor            position of the light
//   rounding, slack   of umbrage_anchored_place, from a face's axes
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_cube_maps_places(UMBRAGE_HIGHP vec4 face, UMBRAGE_HIGHP vec4 anchor,
                                            UMBRAGE_HIGHP vec4 rounding, UMBRAGE_HIGHP vec4 slack,
                                            UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec3 world,
                                            UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec3 m = abs(way);
    bool on_x = m.x >= m.y ? m.x >= m.z : false;
    bool on_y = on_x ? false : m.y >= m.z;
    UMBRAGE_HIGHP float along = on_x ? way.x : (on_y ? way.y : way.z);
    UMBRAGE_HIGHP float flip = along < 0.0 ? -1.0 : 1.0;
    UMBRAGE_HIGHP float number = (on_x ? 0.5 : (on_y ? 2.5 : 4.5)) - 0.5 * flip;
    UMBRAGE_HIGHP vec2 signs = vec2(on_x ? -flip : (on_y ? 1.0 : flip), on_y ? flip : -1.0);
    UMBRAGE_HIGHP vec2 there = vec2(on_x ? way.z : way.x, on_y ? way.z : way.y) * signs;
    UMBRAGE_HIGHP vec2 across = vec2(on_x ? normal.z : normal.x, on_y ? normal.z : normal.y) * signs;
    UMBRAGE_HIGHP float off_plane = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_HIGHP float rise = face.w / (off_plane == 0.0 ? 1.0e-30 : off_plane);  // as umbrage_receiver_slope
    UMBRAGE_HIGHP vec2 slope = across * rise;
    UMBRAGE_HIGHP float i = 1.0 / max(abs(along), 1.0e-30);
    UMBRAGE_HIGHP float z = face.z * i;
    UMBRAGE_HIGHP vec2 at = there * (face.x * i) + face.y;
    UMBRAGE_HIGHP float steep = abs(slope.x) + abs(slope.y);
    UMBRAGE_HIGHP float moves = rounding.x + rounding.y * i;
    UMBRAGE_HIGHP float off = abs(z) * (moves + slack.y) + slack.z;  // a lens has no rounding.w
    UMBRAGE_HIGHP float all = (moves * rounding.z + slack.x) * steep + off;
    return mat4(vec4(at, z + slack.w, number), vec4(slope, 1.0, all), none, none);
}
#endif
