// SPDX-License-Identifier: MIT
//
// Code that depends on the compiler or its flags, apart from simd/: error reports, and access to the bits of a float.
//
//     umbrage::set_error_handler([](const char* message) { log(message); std::exit(1); });  // with -fno-exceptions
//
#pragma once

#if __cplusplus < 202002L && !(defined(_MSVC_LANG) && _MSVC_LANG >= 202002L)
#error "umbrage needs C++20: -std=c++20, or /std:c++20"
#include <C++20>  // no such file, so that compilers stop before the errors that follow
#endif

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#if defined(GLM_FORCE_CXX98) || defined(GLM_FORCE_CXX03)
#error "umbrage needs GLM's constexpr, which GLM_FORCE_CXX98 and GLM_FORCE_CXX03 switch off: define neither"
#endif

// Marks a function that is compiled for the instruction set of its caller.
#if defined(__GNUC__) || defined(__clang__)
#define UMBRAGE_INLINE __attribute__((always_inline))
#else
#define UMBRAGE_INLINE
#endif

namespace umbrage {

/// Receiver of an error message: "umbrage::function: argument must be condition; got value".
/// Without exceptions, functions call it instead of throwing std::invalid_argument. If it returns, the program ends.
using error_handler = void (*)(const char* message);

namespace detail {

/// Default argument of functions that are templates for compile time only. A file then compiles just those that it
/// calls. It serves functions that use containers, and loops for several instruction sets. Without it umbrage.hpp would
/// take 0.36 s more to compile, half as much again.
struct on_use;

inline error_handler handler = nullptr;

/// Reports bad input to a setup function.
/// @throws std::invalid_argument   if exceptions are switched on
[[noreturn]] inline void fail(const std::string& message) {
#if defined(__cpp_exceptions)
    throw std::invalid_argument(message);
#else
    if (handler) handler(message.c_str());
    else std::fprintf(stderr, "%s\n", message.c_str());
    std::abort();
#endif
}

/// std::bit_cast, which some C++20 standard libraries lack.
template <class To, class From>
[[nodiscard]] UMBRAGE_INLINE constexpr To bit_cast(const From& from) {
#if defined(__cpp_lib_bit_cast)
    return std::bit_cast<To>(from);
#else
    return __builtin_bit_cast(To, from);
#endif
}

}  // namespace detail

/// Sets the handler for errors in builds without exceptions. With exceptions nothing calls it.
/// @param handler   nullptr: print the message to standard error and end the program
/// @return          the previous handler
inline error_handler set_error_handler(error_handler handler) {
    const error_handler before = detail::handler;
    detail::handler = handler;
    return before;
}

}  // namespace umbrage
