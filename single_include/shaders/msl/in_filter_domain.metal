// umbrage 0.1.0, in_filter_domain: true for receivers that a filter compares; others are lit. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
inline bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
inline bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif
