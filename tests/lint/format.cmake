# SPDX-License-Identifier: MIT
#
# Fails when a C++ file is not as clang-format leaves it. Its versions differ: 14 is the one that counts.
cmake_minimum_required(VERSION 3.21)
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
if(NOT version MATCHES "version 14\\.")
    message("skipped: another version, ${version}")
    return()
endif()

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/include/*.[ch]pp ${ROOT}/tests/*.[ch]pp
    ${ROOT}/examples/*.[ch]pp)
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror ${files} WORKING_DIRECTORY ${ROOT}
    RESULT_VARIABLE result ERROR_VARIABLE complaints)
if(result)
    string(REGEX MATCHALL "[^\n]+: error:" places "${complaints}")
    list(TRANSFORM places REPLACE ":[0-9: ]+error:$" "")
    list(REMOVE_DUPLICATES places)
    list(JOIN places " " places)
    message(FATAL_ERROR "Not as clang-format 14 leaves them; run `make format`:\n  ${places}")
endif()
