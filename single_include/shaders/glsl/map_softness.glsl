// umbrage 0.1.0, map_softness: one of eight pairs of a matrix, without dynamic indexing. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CASCADE_COLUMN
#define UMBRAGE_HAS_CASCADE_COLUMN
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
UMBRAGE_HIGHP vec4 umbrage_cascade_column(UMBRAGE_HIGHP mat4 columns, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = number < 0.5 ? columns[0] : columns[1];
    UMBRAGE_HIGHP vec4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_MAP_SOFTNESS
#define UMBRAGE_HAS_MAP_SOFTNESS
// umbrage_map_softness: one of eight pairs of a matrix, two a column, by its index, 0.0 to 7.0
UMBRAGE_HIGHP vec2 umbrage_map_softness(UMBRAGE_HIGHP mat4 eight, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP float column = floor(number * 0.5);
    UMBRAGE_HIGHP vec4 two = umbrage_cascade_column(eight, column);
    return number - 2.0 * column < 0.5 ? vec2(two.x, two.y) : vec2(two.z, two.w);
}
#endif
