// umbrage 0.1.0, cascade_column_8: one of eight columns, without dynamic indexing. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CASCADE_COLUMN_8
#define UMBRAGE_HAS_CASCADE_COLUMN_8
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
UMBRAGE_HIGHP vec4 umbrage_cascade_column_8(UMBRAGE_HIGHP mat4 nearer, UMBRAGE_HIGHP mat4 farther,
                                            UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = umbrage_cascade_column(nearer, number);
    UMBRAGE_HIGHP vec4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
#endif
