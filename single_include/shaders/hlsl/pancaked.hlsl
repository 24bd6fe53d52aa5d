// umbrage 0.1.0, pancaked: casters before the near plane, onto it. Exactness: tier B.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_PANCAKED
#define UMBRAGE_HAS_PANCAKED
// umbrage_pancaked: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
float4 umbrage_pancaked(float4 position, float at_near) {
    precise float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return float4(position.x, position.y, before ? plane : position.z, position.w);
}
#endif
