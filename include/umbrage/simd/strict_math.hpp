// SPDX-License-Identifier: MIT
//
// Keeps -ffast-math out of code whose bits are promised:
//
//     UMBRAGE_STRICT_MATH
//     namespace umbrage { ... }  // sums stay in their order, quotients stay quotients, -0 stays -0
//     UMBRAGE_END_STRICT_MATH
//
// Comparisons with NaN are not kept: under -ffinite-math-only GCC shortens them even here, so that code which may meet
// a NaN tests its bits. Denormals may be flushed, which is a mode of the processor. Without the flag these macros are
// empty, as they are for clang where it has no such pragma (version 14: all but x86).
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

namespace umbrage::detail {

/// Whether the compiler takes it that no float is a NaN. Without external linkage: files may differ.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
constexpr bool finite_math_only = true;
#else
constexpr bool finite_math_only = false;
#endif

}  // namespace umbrage::detail
