# SPDX-License-Identifier: MIT
#
# Fails when a header asks which compiler, machine or flags it is compiled with, or uses what only some compilers have,
# unless it is one of the five whose purpose that is.
cmake_minimum_required(VERSION 3.21)
set(allowed core/config.hpp simd/dispatch.hpp simd/lanes.hpp simd/memory.hpp simd/strict_math.hpp)
string(JOIN | forbidden
    __GNUC__ __clang _MSC_VER __INTEL __builtin_ __attribute__ __declspec __extension__ __has_ __cpp_ __cplusplus _Pragma
    "__[A-Z_]+_MATH" __SSE __AVX __FMA __x86_64 __i386 __aarch64 __ARM [a-z]+intrin\\.h)

file(GLOB_RECURSE headers RELATIVE ${INCLUDE}/umbrage ${INCLUDE}/umbrage/*.hpp)
foreach(header IN LISTS headers)
    file(STRINGS ${INCLUDE}/umbrage/${header} lines REGEX "${forbidden}")
    if(header IN_LIST allowed)
        string(APPEND seen "${lines}")
    else()
        foreach(line IN LISTS lines)
            message(SEND_ERROR "${header} depends on the compiler, which is for simd/ and core/config.hpp: ${line}")
        endforeach()
    endif()
endforeach()
if(NOT seen MATCHES "__GNUC__" OR NOT seen MATCHES "__builtin_")
    message(FATAL_ERROR "The headers that may depend on the compiler seem not to: does this test still look at them?")
endif()
