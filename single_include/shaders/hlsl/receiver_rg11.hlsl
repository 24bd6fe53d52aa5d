// umbrage 0.1.0, receiver_rg11: receiver to a level, for maps that are not decoded. Exactness: tier B.
// receiver_rg11, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_RECEIVER_RG11
#define UMBRAGE_HAS_RECEIVER_RG11
// umbrage_receiver_rg11: receiver depth on the scale of umbrage_level_rg11. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
float umbrage_receiver_rg11(float depth, float edge) {
    precise float level = (ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif
