# SPDX-License-Identifier: MIT
#
# Runs a recipe by COMMAND and compares its picture, FOLDER/NAME.png, with C++; where it writes FOLDER/NAME.floats, a
# map, with what C++ looks up in that one, too.
cmake_minimum_required(VERSION 3.21)
file(MAKE_DIRECTORY ${FOLDER})
set(picture ${FOLDER}/${NAME}.png)
set(map ${FOLDER}/${NAME}.floats)
file(REMOVE ${picture} ${map})
execute_process(COMMAND ${COMMAND} ${picture} ${map} RESULT_VARIABLE status OUTPUT_VARIABLE log ERROR_VARIABLE log)
if(status AND log MATCHES "no OpenGL|found 0 devices|ErrorIncompatibleDriver|SKIPPED: |No module named")
    message("SKIPPED: ${log}")
    return()
elseif(status OR NOT log STREQUAL "")
    message(FATAL_ERROR "${COMMAND}: ${status}\n${log}")
endif()

if(NOT EXISTS ${map})
    set(map "")
endif()
execute_process(COMMAND ${COMPARE} ${NAME} ${picture} ${map} RESULT_VARIABLE status OUTPUT_VARIABLE log ERROR_VARIABLE log)
message("${log}")
if(NOT status EQUAL 0)
    message(FATAL_ERROR "${picture} is not what C++ makes of it")
endif()
