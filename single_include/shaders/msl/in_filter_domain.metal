// umbrage 0.1.0, in_filter_domain: receivers that a filter compares; it takes the others as lit. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
inline bool umbrage_inside_texel_space(float2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: whether a filter compares; outside texel space and beyond the far plane all is lit
inline bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif
