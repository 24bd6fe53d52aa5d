# SPDX-License-Identifier: MIT
#
# Fails when umbrage.hpp leaves more macros defined than these, the version aside, or any without our prefix.
cmake_minimum_required(VERSION 3.21)
set(expected UMBRAGE_END_STRICT_MATH UMBRAGE_INLINE UMBRAGE_NO_OVERLAP UMBRAGE_STRICT_MATH)

# macros_of(TEXT OUT): names of the macros defined once TEXT has been compiled.
function(macros_of text out)
    file(WRITE macros.cpp "${text}")
    execute_process(COMMAND ${CXX} -dM -E macros.cpp OUTPUT_VARIABLE defines COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "#define [A-Za-z_0-9]+" names "${defines}")
    list(TRANSFORM names REPLACE "#define " "")
    list(SORT names)
    set(${out} "${names}" PARENT_SCOPE)
endfunction()

macros_of("#include <umbrage/umbrage.hpp>\n" ours)
list(FILTER ours INCLUDE REGEX "^UMBRAGE_")
list(FILTER ours EXCLUDE REGEX "^UMBRAGE_VERSION_(MAJOR|MINOR|PATCH)$")
if(NOT ours STREQUAL expected)
    message(SEND_ERROR "Macros that stay defined after umbrage.hpp:\n  ${ours}\nThere should be just:\n  ${expected}")
endif()

# A macro of another name would be one of ours that users cannot tell.
file(GLOB_RECURSE headers RELATIVE ${INCLUDE} ${INCLUDE}/umbrage/*.hpp)
foreach(header IN LISTS headers)
    file(STRINGS ${INCLUDE}/${header} lines REGEX "^ *# *define ")
    list(FILTER lines EXCLUDE REGEX "define UMBRAGE_")
    if(lines)
        message(SEND_ERROR "${header} defines a macro without the prefix UMBRAGE_: ${lines}")
    endif()
endforeach()
