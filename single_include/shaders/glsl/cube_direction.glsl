// umbrage 0.1.0, MIT License: cube_direction

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

#ifndef UMBRAGE_HAS_CUBE_DIRECTION
#define UMBRAGE_HAS_CUBE_DIRECTION
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_direction(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 st) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float u = st.x * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = st.y * 2.0 - 1.0;
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(1.0, -v, -u) : vec3(-1.0, -v, u);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(u, 1.0, v) : vec3(u, -1.0, -v);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(u, -v, 1.0) : vec3(-u, -v, -1.0);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif
