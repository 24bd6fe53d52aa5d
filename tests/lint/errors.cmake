# SPDX-License-Identifier: MIT
#
# Fails when a header writes the message of an error itself: require and refuse of core/check.hpp give all of them one
# form. The printer of WGSL alone has errors without an argument.
cmake_minimum_required(VERSION 3.21)
set(allowed core/check.hpp core/config.hpp shader/translate/wgsl_expression.hpp)

file(GLOB_RECURSE headers RELATIVE ${INCLUDE}/umbrage ${INCLUDE}/umbrage/*.hpp)
foreach(header IN LISTS headers)
    file(STRINGS ${INCLUDE}/umbrage/${header} lines REGEX "(^|[^a-z_])(fail\\(|throw std::|std::abort|\"umbrage::)")
    if(header IN_LIST allowed)
        string(APPEND seen "${lines}")
    else()
        foreach(line IN LISTS lines)
            message(SEND_ERROR "${header} writes an error's message, which is for core/check.hpp: ${line}")
        endforeach()
    endif()
endforeach()
if(NOT seen MATCHES "void fail\\(" OR NOT seen MATCHES " fail\\(message")
    message(FATAL_ERROR "No header seems to write messages: does this test still look at them?")
endif()
