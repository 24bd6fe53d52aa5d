// umbrage 0.1.0, pcss_radius: penumbra radius from the mean depth of blockers. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// pcss_radius, tier C: within 1/1024 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

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

#ifndef UMBRAGE_HAS_PCSS_RADIUS
#define UMBRAGE_HAS_PCSS_RADIUS
// umbrage_pcss_radius: radius of a penumbra along x and y in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
UMBRAGE_HIGHP vec2 umbrage_pcss_radius(UMBRAGE_HIGHP vec2 found, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP vec4 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    UMBRAGE_HIGHP float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    UMBRAGE_HIGHP float apart = forward ? receiver - mean : mean - receiver;
    UMBRAGE_HIGHP vec2 radius = vec2(softness.x, softness.y) * 4096.0 * apart;
    UMBRAGE_HIGHP float min_radius = softness.z * 0.0625;
    UMBRAGE_HIGHP float max_radius = softness.w * 0.0625;
    return vec2(radius.x > min_radius ? min(radius.x, max_radius) : min_radius,
                radius.y > min_radius ? min(radius.y, max_radius) : min_radius);
}
#endif
