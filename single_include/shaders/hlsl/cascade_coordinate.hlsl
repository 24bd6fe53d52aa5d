// umbrage 0.1.0, MIT License: cascade_coordinate

#ifndef UMBRAGE_HAS_CASCADE_COORDINATE
#define UMBRAGE_HAS_CASCADE_COORDINATE
// umbrage_cascade_coordinate: a point, rotated into the light's directions, in a cascade's map: texels and depth
float3 umbrage_cascade_coordinate(float3 light, float4 scale, float4 offset) {
    float3 start = float3(offset.x, offset.y, offset.z);
    precise float3 at = light * float3(scale.x, scale.y, scale.z) + start;
    return at;
}
#endif
