// umbrage 0.1.0, MIT License: diffuse_ambient

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DIFFUSE_AMBIENT
#define UMBRAGE_HAS_DIFFUSE_AMBIENT
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient); for n_dot_l <= 0, NaN: ambient
inline float3 umbrage_diffuse_ambient(float3 albedo, float ambient, float n_dot_l, float visibility) {
    float light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // a max of n_dot_l and 0.0 is NaN for a signalling one on Mesa
}
#endif
