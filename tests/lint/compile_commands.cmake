# SPDX-License-Identifier: MIT
#
# Fails when an editor would not find how a .cpp file is compiled: each has an entry of its own in compile_commands.json.
#
#     cmake -D ROOT=source-folder -D BUILD=build-folder -P compile_commands.cmake
cmake_minimum_required(VERSION 3.21)
# Examples are configured after this test, so the cache says what they lack.
file(STRINGS ${BUILD}/CMakeCache.txt lacks REGEX "^UMBRAGE_(EXAMPLES|VIEWER)_LIBRARIES:INTERNAL=OFF$|_HEADERS:PATH=.*-NOTFOUND$")
if(lacks)
    message("SKIPPED: needs every library of the examples: ${lacks}")
    return()
endif()
file(READ ${BUILD}/compile_commands.json commands)
file(GLOB_RECURSE files ${ROOT}/include/*.cpp ${ROOT}/tests/*.cpp ${ROOT}/examples/*.cpp ${ROOT}/single_include/npm/*.cpp)
list(LENGTH files count)
set(missing "")
foreach(file IN LISTS files)
    string(FIND "${commands}" "\"file\": \"${file}\"" found)
    if(found EQUAL -1)
        string(APPEND missing "\n  ${file}")
    endif()
endforeach()
if(missing OR count LESS 100)
    message(FATAL_ERROR "Of ${count} files, no entry in ${BUILD}/compile_commands.json for:${missing}")
endif()
