# SPDX-License-Identifier: MIT
#
# Compiles every shader that the pages' programs have written to FOLDER.
cmake_minimum_required(VERSION 3.21)
file(GLOB shaders ${FOLDER}/*.frag ${FOLDER}/*.vert)
if(NOT shaders)
    message(FATAL_ERROR "No shaders in ${FOLDER}")
endif()
foreach(shader IN LISTS shaders)
    execute_process(COMMAND ${GLSLANG} ${shader} OUTPUT_VARIABLE log RESULT_VARIABLE failed)
    if(failed)
        message(SEND_ERROR "${log}")
    endif()
endforeach()
