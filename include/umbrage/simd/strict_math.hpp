// SPDX-License-Identifier: MIT
//
// Keeps -ffast-math out of code whose bits are promised:
//
//     UMBRAGE_STRICT_MATH
//     namespace umbrage { ... }  // sums stay in their order, quotients stay quotients, -0 stays -0
//     UMBRAGE_END_STRICT_MATH
//
// NaNs remain for tests of bits to find: GCC keeps the shorter comparisons that -ffinite-math-only brings. Denormals
// may still be flushed, a state of the machine. Without the flag these macros are empty, as they are for clang where it
// has no such pragma (version 14: all but x86).
#pragma once

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#if defined(__clang__) && (defined(__x86_64__) || __clang_major__ > 14)
#define UMBRAGE_STRICT_MATH _Pragma("float_control(precise, on, push)")
#define UMBRAGE_END_STRICT_MATH _Pragma("float_control(pop)")
#elif defined(__GNUC__) && !defined(__clang__)
#define UMBRAGE_STRICT_MATH _Pragma("GCC push_options") _Pragma("GCC optimize(\"no-fast-math\")")
#define UMBRAGE_END_STRICT_MATH _Pragma("GCC pop_options")
#endif
#endif

#ifndef UMBRAGE_STRICT_MATH
#define UMBRAGE_STRICT_MATH
#define UMBRAGE_END_STRICT_MATH
#endif
