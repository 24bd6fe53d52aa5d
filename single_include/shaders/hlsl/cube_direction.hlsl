// umbrage 0.1.0, MIT License: cube_direction

#ifndef UMBRAGE_HAS_CUBE_DIRECTION
#define UMBRAGE_HAS_CUBE_DIRECTION
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
float3 umbrage_cube_direction(float face, float2 st) {
    precise float u = st.x * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    precise float v = st.y * 2.0 - 1.0;
    float3 x = face < 0.5 ? float3(1.0, -v, -u) : float3(-1.0, -v, u);
    float3 y = face < 2.5 ? float3(u, 1.0, v) : float3(u, -1.0, -v);
    float3 z = face < 4.5 ? float3(u, -v, 1.0) : float3(-u, -v, -1.0);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif
