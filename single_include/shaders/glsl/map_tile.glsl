// umbrage 0.1.0, map_tile: first texel of a map in an atlas of equal maps. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_MAP_TILE
#define UMBRAGE_HAS_MAP_TILE
// umbrage_map_tile: first texel of a map in an atlas of maps of size texels, row by row
//   number    number of the map, a whole number
//   columns   maps per row, and 1.0 / their number
UMBRAGE_HIGHP vec2 umbrage_map_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 columns, UMBRAGE_HIGHP vec2 size) {
    UMBRAGE_HIGHP float row = floor((number + 0.5) * columns.y);
    return vec2(number - row * columns.x, row) * size;
}
#endif
