// SPDX-License-Identifier: MIT
//
// Dispatch of a loop to the machine's best instruction set at run time. The loop is compiled for each set, without
// flags or intrinsics.
//
//     umbrage::detail::on_best_isa([&](auto) UMBRAGE_INLINE { for (...) block(...); });
//
// A body is inlined into thin functions that carry the target. Functions that it calls must be UMBRAGE_INLINE too, or
// they are compiled for the base set. At -O2, GCC only vectorizes loops whose count it knows, and no `c ? x : y` on
// floats. So loops run over blocks of 64, and select on the bits.
//
// UMBRAGE_FORCE_ISA=base, =avx2 or =avx512 sets the choice, and nothing wider is compiled. A machine without that set
// uses the next lower one. No choice changes a bit of a result of tier A. It has to be the same in all files of a
// program.
#pragma once

#include <type_traits>

#include <umbrage/core/config.hpp>

// Put before a loop that writes memory from which it does not read. At -O2, GCC does not check that at run time.
#if defined(__GNUC__) && !defined(__clang__)
#define UMBRAGE_NO_OVERLAP _Pragma("GCC ivdep")
#else
#define UMBRAGE_NO_OVERLAP
#endif

namespace umbrage::detail {

enum class isa { base, avx2, avx512 };

template <isa Set>
using isa_constant = std::integral_constant<isa, Set>;

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
inline constexpr bool has_dispatch = true;

/// Best instruction set of this machine, among those with their own path.
[[nodiscard]] inline isa best_isa() {
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2")) return isa::base;
    const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return wide ? isa::avx512 : isa::avx2;
}

template <class Body>
__attribute__((target("avx2"), noinline)) void on_avx2(const Body& body) {
    body(isa_constant<isa::avx2>{});
}
template <class Body>
__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"), noinline)) void on_avx512(const Body& body) {
    body(isa_constant<isa::avx512>{});
}
#else
inline constexpr bool has_dispatch = false;
[[nodiscard]] inline isa best_isa() { return isa::base; }
#endif

/// Widest set for which anything is compiled.
#if defined(UMBRAGE_FORCE_ISA)
inline constexpr isa widest_isa = has_dispatch ? isa::UMBRAGE_FORCE_ISA : isa::base;
#else
inline constexpr isa widest_isa = has_dispatch ? isa::avx512 : isa::base;
#endif

/// Instruction set that image functions use. Tests set it to run every path.
inline isa isa_in_use = best_isa() < widest_isa ? best_isa() : widest_isa;

/// Runs the body, compiled for the instruction set in use, which it receives as a constant. Only for results that no
/// contraction to FMA can change.
template <class Body>
void on_best_isa(const Body& body) {
    if constexpr (widest_isa >= isa::avx512)
        if (isa_in_use >= isa::avx512) return on_avx512(body);
    if constexpr (widest_isa >= isa::avx2)
        if (isa_in_use >= isa::avx2) return on_avx2(body);
    body(isa_constant<isa::base>{});
}

/// Runs a body with sums of products that round. AVX-512 includes FMA, with which compilers change such results.
template <class Body>
void on_best_isa_without_fma(const Body& body) {
    if constexpr (widest_isa >= isa::avx2)
        if (isa_in_use != isa::base) return on_avx2(body);
    body(isa_constant<isa::base>{});
}

/// Runs the body in a separate function, for the instruction set of its caller. A large body with several callers is
/// then compiled once.
template <class Body>
void out_of_line(isa_constant<isa::base> set, const Body& body) {
    body(set);
}
template <isa Set, class Body>
void out_of_line(isa_constant<Set>, const Body& body) {
    if constexpr (Set == isa::avx512) on_avx512(body);
    else on_avx2(body);
}

/// Number of elements of a loop whose count the compiler knows. Arrays of that size start at a cache line. A loop over
/// an array that starts elsewhere, as may happen on a stack, can take several times as long.
inline constexpr int block = 64;

}  // namespace umbrage::detail
