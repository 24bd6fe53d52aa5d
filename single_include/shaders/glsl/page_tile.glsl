// umbrage 0.1.0, page_tile: first texel of a page in an atlas of eight a row. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_PAGE_TILE
#define UMBRAGE_HAS_PAGE_TILE
// umbrage_page_tile: first texel of a page, a whole number, in an atlas of pages of size texels, eight a row
UMBRAGE_HIGHP vec2 umbrage_page_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = floor(number * 0.125);
    return vec2(number - row * 8.0, row) * size;
}
#endif
