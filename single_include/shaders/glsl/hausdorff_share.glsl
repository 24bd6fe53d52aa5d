// umbrage 0.1.0, MIT License: hausdorff_share

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

#ifndef UMBRAGE_HAS_HAUSDORFF_SHARE
#define UMBRAGE_HAS_HAUSDORFF_SHARE
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
UMBRAGE_HIGHP float umbrage_hausdorff_share(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float z) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = (b.z - b.x) - z * (b.y - 1.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float n = (b.w - b.y) - z * (b.z - b.x);
    UMBRAGE_HIGHP float f = n / d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float s = z + f;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = z * f;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float above = (b.z - (1.0 + s) * b.y) + ((s + p) * b.x - p);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float below = -2.0 * ((1.0 + z) * (1.0 + f));
    UMBRAGE_PRECISE UMBRAGE_HIGHP float between = (f * f - 1.0) * (f - z);
    UMBRAGE_HIGHP float end = above / below;
    UMBRAGE_HIGHP float other = d / between;
    return end + (f < z ? other : 0.0);
}
#endif
