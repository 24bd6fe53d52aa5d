# SPDX-License-Identifier: MIT
#
# Fails when a C++ file of FOLDER is not as clang-format 14 leaves it.
cmake_minimum_required(VERSION 3.21)
file(GLOB_RECURSE files RELATIVE ${FOLDER} ${FOLDER}/*.[ch]pp)
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror ${files} WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE result ERROR_VARIABLE complaints)
if(result)
    string(REGEX MATCHALL "[^\n]+: error:" places "${complaints}")
    list(TRANSFORM places REPLACE ":[0-9: ]+error:$" "")
    list(REMOVE_DUPLICATES places)
    list(JOIN places " " places)
    message(FATAL_ERROR "Not as clang-format 14 leaves them; run `make format`:\n  ${places}")
endif()
