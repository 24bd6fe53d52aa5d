// umbrage 0.1.0, reversed_depth_from_view_z: view-space z to reversed perspective depth. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// reversed_depth_from_view_z, tier C: within 13 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_REVERSED_DEPTH_FROM_VIEW_Z
#define UMBRAGE_HAS_REVERSED_DEPTH_FROM_VIEW_Z
// umbrage_reversed_depth_from_view_z: perspective depth in [0, 1], 1.0 at z_near, from the distance along the light's
// axis
UMBRAGE_HIGHP float umbrage_reversed_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                       UMBRAGE_HIGHP float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
#endif
