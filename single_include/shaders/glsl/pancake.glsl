// umbrage 0.1.0, pancake: casters clamped to the near plane (pancaking). Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// pancake, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_PANCAKE
#define UMBRAGE_HAS_PANCAKE
// umbrage_pancake: clip space position, clamped to the near plane if it lies in front of it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
UMBRAGE_HIGHP vec4 umbrage_pancake(UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP float at_near) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return vec4(position.x, position.y, before ? plane : position.z, position.w);
}
#endif
