// SPDX-License-Identifier: MIT
//
// Protection from -ffast-math for code with guaranteed bits.
//     UMBRAGE_STRICT_MATH
//     namespace umbrage { ... }  // sums stay in their order, quotients stay quotients, -0 stays -0
//     UMBRAGE_END_STRICT_MATH
//
// Comparisons with NaN are not protected: under -ffinite-math-only GCC shortens them even here. Code that may see a NaN
// tests its bits. Denormals may be flushed, which is a mode of the processor. Without the flag these macros are empty.
// They are also empty for clang where it has no such pragma (version 14: all but x86).
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

/// True when the compiler assumes that no float is NaN. It has no external linkage, since files may differ.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
constexpr bool finite_math_only = true;
#else
constexpr bool finite_math_only = false;
#endif

}  // namespace umbrage::detail
