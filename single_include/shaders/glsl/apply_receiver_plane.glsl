// umbrage 0.1.0, apply_receiver_plane: stored depth, or the far plane's if lit along the receiver's plane. Exactness:
//   tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// apply_receiver_plane, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by compare, direction.

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

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_PLANE_REFERENCE
#define UMBRAGE_HAS_PLANE_REFERENCE
// umbrage_plane_reference: depth of the receiver, or of its plane at a texel where that is nearer to the light
//   slope   slope of the receiver's plane, per texel, no NaN
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
UMBRAGE_HIGHP float umbrage_plane_reference(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 way = texel - (vec2(at.x, at.y) - 0.5);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = (at.z + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, at.z) : max(plane, at.z);
}
#endif

#ifndef UMBRAGE_HAS_APPLY_RECEIVER_PLANE
#define UMBRAGE_HAS_APPLY_RECEIVER_PLANE
// umbrage_apply_receiver_plane: depth of a texel that shadows the receiver's plane; any other has the far plane's
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
UMBRAGE_HIGHP float umbrage_apply_receiver_plane(UMBRAGE_HIGHP float stored, UMBRAGE_HIGHP vec2 slope,
                                                 UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP float lit = umbrage_compare(umbrage_plane_reference(slope, at, texel), stored);
    return lit > 0.5 ? umbrage_cleared_depth() : stored;
}
#endif
