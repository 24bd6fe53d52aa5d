// umbrage 0.1.0, penumbra: radius of a penumbra from the distance to the blocker. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_PENUMBRA
#define UMBRAGE_HAS_PENUMBRA
// umbrage_penumbra: radius of a penumbra along x and y in 1/16 texel, integers
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
UMBRAGE_HIGHP vec2 umbrage_penumbra(UMBRAGE_HIGHP float apart, UMBRAGE_HIGHP vec4 softness) {
    UMBRAGE_HIGHP vec2 radius = floor(vec2(softness.x, softness.y) * apart);
    return min(max(radius, vec2(softness.z, softness.z)), vec2(softness.w, softness.w));
}
#endif
