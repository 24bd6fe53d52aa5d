# SPDX-License-Identifier: MIT
#
# Compiles what no driver here runs, into FOLDER: the shaders of Direct3D 12 by GLSLANG, as SPIR-V; the program that binds
# them by MINGW, with its headers of Direct3D and GLM and stb in LINKS; the shaders of Metal by CLANG, as C++, which METAL
# lends its standard library.
cmake_minimum_required(VERSION 3.21)
function(compile name)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE log ERROR_VARIABLE log)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${name} does not compile:\n${log}")
    endif()
endfunction()

if(API STREQUAL direct3d12)
    foreach(stage vert:place frag:depth frag:color)
        string(REPLACE ":" ";" stage ${stage})
        list(GET stage 0 kind)
        list(GET stage 1 entry)
        compile(${entry} ${GLSLANG} -D -V -S ${kind} -e ${entry} -o ${FOLDER}/${entry}.spv ${FOLDER}/direct3d12.hlsl)
    endforeach()
    if(NOT MINGW)
        message("SKIPPED: no MinGW, the program that binds its shaders is not compiled (Debian: g++-mingw-w64-x86-64-posix)")
        return()
    endif()
    compile(direct3d12.cpp ${MINGW} -std=c++20 -fsyntax-only -Wall -Wextra -Wno-missing-field-initializers -Werror
            -I${ROOT}/include -isystem ${LINKS} ${ROOT}/examples/recipes/direct3d12.cpp)
else()
    if(NOT CLANG)
        message("SKIPPED: no clang++, the shaders of Metal are not compiled")
        return()
    endif()
    compile(metal.metal ${CLANG} -x c++ -std=c++20 -fsyntax-only -w -cl-single-precision-constant -I${METAL}
            ${FOLDER}/metal.metal)
endif()
