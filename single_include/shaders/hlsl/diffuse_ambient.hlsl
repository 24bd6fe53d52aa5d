// umbrage 0.1.0, MIT License: diffuse_ambient

#ifndef UMBRAGE_HAS_DIFFUSE_AMBIENT
#define UMBRAGE_HAS_DIFFUSE_AMBIENT
// umbrage_diffuse_ambient: albedo * (visibility * max(n_dot_l, 0) * (1 - ambient) + ambient)
float3 umbrage_diffuse_ambient(float3 albedo, float ambient, float n_dot_l, float visibility) {
    float facing = n_dot_l > 0.0 ? n_dot_l : 0.0;
    precise float light = visibility * facing * (1.0 - ambient) + ambient;
    return albedo * light;
}
#endif
