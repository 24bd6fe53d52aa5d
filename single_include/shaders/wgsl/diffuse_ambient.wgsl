// umbrage 0.1.0, diffuse_ambient: diffuse plus ambient light of a surface. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// diffuse_ambient, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient)
//   for n_dot_l <= 0.0 and NaN: albedo * ambient
fn umbrage_diffuse_ambient(albedo: vec3f, ambient: vec3f, n_dot_l: f32, visibility: f32) -> vec3f {
    let light: vec3f = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * select(ambient, light, n_dot_l > 0.0);  // max gives NaN for a signalling NaN on Mesa
}
