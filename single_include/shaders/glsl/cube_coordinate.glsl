// umbrage 0.1.0, MIT License: cube_coordinate

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

#ifndef UMBRAGE_HAS_CUBE_FACE
#define UMBRAGE_HAS_CUBE_FACE
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
UMBRAGE_HIGHP float umbrage_cube_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 m = abs(direction);
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float y = direction.y < 0.0 ? 3.0 : 2.0;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_COORDINATE
#define UMBRAGE_HAS_CUBE_COORDINATE
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    bool on_x = face < 1.5;
    bool on_y = face > 1.5 && face < 3.5;
    UMBRAGE_HIGHP float along = on_x ? direction.x : (on_y ? direction.y : direction.z);
    UMBRAGE_HIGHP float m = abs(along);
    UMBRAGE_HIGHP float z = along < 0.0 ? -direction.z : direction.z;
    UMBRAGE_HIGHP float x = along < 0.0 ? -direction.x : direction.x;
    UMBRAGE_HIGHP float sc = on_x ? -z : (on_y ? direction.x : x);
    UMBRAGE_HIGHP float tc = on_y ? z : -direction.y;
    return vec3((sc + m) / (m + m), (tc + m) / (m + m), face);
}
#endif
