// umbrage 0.1.0, cascade_by_depth: cascade that contains a view depth. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CASCADE_BY_DEPTH
#define UMBRAGE_HAS_CASCADE_BY_DEPTH
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
UMBRAGE_HIGHP float umbrage_cascade_by_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec3 ends) {
    UMBRAGE_HIGHP int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
#endif
