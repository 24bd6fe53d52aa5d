// umbrage 0.1.0, MIT License: cube_coordinate

#ifndef UMBRAGE_HAS_CUBE_FACE
#define UMBRAGE_HAS_CUBE_FACE
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
float umbrage_cube_face(float3 direction) {
    float3 m = abs(direction);
    float x = direction.x < 0.0 ? 1.0 : 0.0;
    float y = direction.y < 0.0 ? 3.0 : 2.0;
    float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_COORDINATE
#define UMBRAGE_HAS_CUBE_COORDINATE
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
float3 umbrage_cube_coordinate(float3 direction) {
    float face = umbrage_cube_face(direction);
    bool on_x = face < 1.5;
    bool on_y = face > 1.5 && face < 3.5;
    float along = on_x ? direction.x : (on_y ? direction.y : direction.z);
    float m = abs(along);
    float z = along < 0.0 ? -direction.z : direction.z;
    float x = along < 0.0 ? -direction.x : direction.x;
    float sc = on_x ? -z : (on_y ? direction.x : x);
    float tc = on_y ? z : -direction.y;
    return float3((sc + m) / (m + m), (tc + m) / (m + m), face);
}
#endif
