# SPDX-License-Identifier: MIT
#
# Compiles what write_bindings or shadows_write_texts has written into FOLDER: GLSL and HLSL by GLSLANG, Metal as C++ by
# CLANG, which METAL lends its standard library. accept_wgsl.js is for WGSL.
function(compile name)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE log ERROR_VARIABLE log)
    if(NOT status EQUAL 0)
        string(SUBSTRING "${log}" 0 2000 log)
        message(SEND_ERROR "${name} does not compile:\n${log}")
    endif()
endfunction()

file(GLOB shaders ${FOLDER}/glsl/*.frag)
list(LENGTH shaders count)
if(NOT count EQUAL 13)
    message(FATAL_ERROR "${count} dialects in ${FOLDER}/glsl")
endif()
foreach(shader IN LISTS shaders)
    if(shader MATCHES "vulkan")
        compile(${shader} ${GLSLANG} -V -o ${FOLDER}/trial.spv ${shader})
    else()
        compile(${shader} ${GLSLANG} ${shader})
    endif()
endforeach()
compile(all.hlsl ${GLSLANG} -D -V -e main -S frag -o ${FOLDER}/trial.spv ${FOLDER}/all.hlsl)

if(CLANG)
    compile(all.metal ${CLANG} -x c++ -std=c++20 -fsyntax-only -w -cl-single-precision-constant -I${METAL} ${FOLDER}/all.metal)
endif()
