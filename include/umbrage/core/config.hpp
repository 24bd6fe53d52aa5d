// SPDX-License-Identifier: MIT
//
// What depends on the compiler or its flags, outside of simd/: how errors are reported, and how bits are read.
//
//     umbrage::set_error_handler([](const char* message) { log(message); std::exit(1); });  // with -fno-exceptions
//
#pragma once

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#if defined(GLM_FORCE_CXX98) || defined(GLM_FORCE_CXX03)
#error "umbrage needs GLM's constexpr, which GLM_FORCE_CXX98 and GLM_FORCE_CXX03 switch off: define neither"
#endif

// A function that is compiled for whatever instruction set its caller is compiled for.
#if defined(__GNUC__) || defined(__clang__)
#define UMBRAGE_INLINE __attribute__((always_inline))
#else
#define UMBRAGE_INLINE
#endif

namespace umbrage {

/// Takes the message of an error, "umbrage::function: argument must be condition; got value". Where exceptions are
/// switched off, functions call it in place of throwing std::invalid_argument, and end the program if it returns.
using error_handler = void (*)(const char* message);

namespace detail {

/// The default argument of what is a template for one reason: a file compiles what it calls, not all that it includes.
/// For functions that use containers and for loops for several instruction sets, where nothing else makes them so.
/// Without it umbrage.hpp would take 0.36 s more to compile, half as much again.
struct on_use;

inline error_handler handler = nullptr;

/// Reports bad input to a set-up function.
/// @throws std::invalid_argument   where exceptions are switched on
[[noreturn]] inline void fail(const std::string& message) {
#if defined(__cpp_exceptions)
    throw std::invalid_argument(message);
#else
    if (handler) handler(message.c_str());
    else std::fprintf(stderr, "%s\n", message.c_str());
    std::abort();
#endif
}

/// std::bit_cast, which some libraries of C++20 lack.
template <class To, class From>
[[nodiscard]] UMBRAGE_INLINE constexpr To bit_cast(const From& from) {
#if defined(__cpp_lib_bit_cast)
    return std::bit_cast<To>(from);
#else
    return __builtin_bit_cast(To, from);
#endif
}

}  // namespace detail

/// Sets what bad input leads to where exceptions are switched off; where they are on, nothing calls it.
/// @param handler   nullptr: the message goes to standard error and the program ends
/// @return          the one before
inline error_handler set_error_handler(error_handler handler) {
    const error_handler before = detail::handler;
    detail::handler = handler;
    return before;
}

}  // namespace umbrage
