// umbrage 0.1.0, orthographic_depth_from_view_z: view-space z to orthographic depth. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// orthographic_depth_from_view_z, tier C: within 5 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_ORTHOGRAPHIC_DEPTH_FROM_VIEW_Z
#define UMBRAGE_HAS_ORTHOGRAPHIC_DEPTH_FROM_VIEW_Z
// umbrage_orthographic_depth_from_view_z: orthographic depth in [0, 1] from the distance along the light's axis
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
UMBRAGE_HIGHP float umbrage_orthographic_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                           UMBRAGE_HIGHP float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
#endif
