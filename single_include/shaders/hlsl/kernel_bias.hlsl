// umbrage 0.1.0, kernel_bias: bias from kernel width and angle of the light. Exactness: tier C.
// kernel_bias, tier C: within 30 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_KERNEL_BIAS
#define UMBRAGE_HAS_KERNEL_BIAS
// umbrage_kernel_bias: distance along the light that a kernel extends beyond a surface's plane, in width's unit
//   normal     surface normal
//   direction  direction of the light, of length one
//   way        from the light to the point over w; for a directional light its direction
//   width      sqrt(2) reach texel
//   greatest   limit of the tangent
float umbrage_kernel_bias(float3 normal, float3 direction, float3 way, float width, float greatest) {
    precise float x = normal.y * direction.z + normal.z * -direction.y;
    precise float y = normal.z * direction.x + normal.x * -direction.z;
    precise float z = normal.x * direction.y + normal.y * -direction.x;
    precise float square = x * x + y * y + z * z;
    float sine = sqrt(square);
    precise float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    precise float edge = cosine * greatest;
    float tangent = edge > sine ? sine / cosine : greatest;
    float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
#endif
