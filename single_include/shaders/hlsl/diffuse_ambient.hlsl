// umbrage 0.1.0, diffuse_ambient: diffuse plus ambient light of a surface. Exactness: tier B.
// diffuse_ambient, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_DIFFUSE_AMBIENT
#define UMBRAGE_HAS_DIFFUSE_AMBIENT
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient)
//   for n_dot_l <= 0.0 and NaN: albedo * ambient
float3 umbrage_diffuse_ambient(float3 albedo, float3 ambient, float n_dot_l, float visibility) {
    precise float3 light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // max gives NaN for a signalling NaN on Mesa
}
#endif
