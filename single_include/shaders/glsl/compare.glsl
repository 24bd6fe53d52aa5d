// umbrage 0.1.0, MIT License: compare

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

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// UMBRAGE_LIT: 1.0 when the receiver is no farther than the stored depth, after #define UMBRAGE_REVERSED no less
#ifndef UMBRAGE_LIT
#ifdef UMBRAGE_REVERSED
#define UMBRAGE_LIT(receiver, stored) ((receiver) >= (stored) ? 1.0 : 0.0)
#else
#define UMBRAGE_LIT(receiver, stored) ((receiver) <= (stored) ? 1.0 : 0.0)
#endif
#endif
// umbrage_compare: visibility of one comparison
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_LIT(receiver, stored);
}
#endif
