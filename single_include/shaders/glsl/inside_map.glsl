// umbrage 0.1.0, inside_map: true if a texel lies inside the map. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_INSIDE_MAP
#define UMBRAGE_HAS_INSIDE_MAP
// umbrage_inside_map: true if a texel lies inside a map of size texels
bool umbrage_inside_map(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
#endif
