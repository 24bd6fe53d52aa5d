// umbrage 0.1.0, sheared_rotation: rotation of a disc, sheared to an ellipse. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// sheared_rotation, tier B: within 2 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_SHEARED_ROTATION
#define UMBRAGE_HAS_SHEARED_ROTATION
// umbrage_sheared_rotation: rotation of a disc, and then a shear along x
//   rotation   from umbrage_disc_rotation
//   shear      by how much x grows with y, both in radii of the ellipse; -2.0 to 2.0
UMBRAGE_HIGHP vec4 umbrage_sheared_rotation(UMBRAGE_HIGHP vec4 rotation, UMBRAGE_HIGHP float shear) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = rotation.x + shear * rotation.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = rotation.y + shear * rotation.w;
    return vec4(x, y, rotation.z, rotation.w);
}
#endif
