# SPDX-License-Identifier: MIT
#
# umbrage-check where it was installed and then moved, from a shell and from a project of CMake.
#
#     cmake -D BUILD=build-folder -D MODULES=node_modules -D WORK=where-to -P installed.cmake
if(NOT EXISTS ${MODULES}/naga-wasm)
    message("SKIPPED: needs naga-wasm in ${MODULES}")
    return()
endif()
file(REMOVE_RECURSE ${WORK})
foreach(component check Unspecified)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first --component ${component}
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(RENAME ${WORK}/first ${WORK}/moved)
set(consumer ${CMAKE_CURRENT_LIST_DIR}/consumer)

# says(STATUS WORDS argument...): the program ends with this status, and says these words.
function(says status words)
    execute_process(COMMAND ${WORK}/moved/bin/umbrage-check ${ARGN} OUTPUT_VARIABLE said ERROR_VARIABLE said
                    RESULT_VARIABLE result)
    string(FIND "${said}" "${words}" at)
    if(at EQUAL -1 OR NOT result EQUAL status)
        message(FATAL_ERROR "umbrage-check ${ARGN} ended with ${result}, not ${status}, or did not say \"${words}\":\n${said}")
    endif()
endfunction()

# in_a_project(NAME result...): the consumer's tests, in their order, end so.
function(in_a_project name)
    execute_process(COMMAND ${CMAKE_COMMAND} -S ${consumer} -B ${WORK}/${name} -D CMAKE_PREFIX_PATH=${WORK}/moved
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${CMAKE_CTEST_COMMAND} WORKING_DIRECTORY ${WORK}/${name} OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX MATCHALL "(Passed|Skipped|Failed) +[0-9.]+ sec" results "${said}")
    list(TRANSFORM results REPLACE " .*" "")
    if(NOT results STREQUAL "${ARGN}")
        message(FATAL_ERROR "The project's tests end with ${results}, not ${ARGN}:\n${said}")
    endif()
endfunction()

says(0 "is hard" ${consumer}/shadow.frag --call "shadow(map, uv, z)")
says(1 "shifted by (1, 1) texel" ${consumer}/shadow.frag --call "shadow(map, uv + 1.0 / size, z)")
set(scripts ${WORK}/moved/share/umbrage/check)
says(2 "npm install --prefix ${scripts} naga-wasm" ${consumer}/pack.wgsl --call "pack(z)")
file(CREATE_LINK ${MODULES} ${scripts}/node_modules SYMBOLIC)
says(0 "is r16" ${consumer}/pack.wgsl --call "pack(z)")
find_program(compiler NAMES clang++ clang++-14 g++)
if(compiler)
    set(metal ${consumer}/shadow.metal --call "shadow(shadow_map, uv, z)" --before)
    says(0 "MSL was compiled as C++" ${metal} "#define BIAS")
    says(1 "bias of 0.01" ${metal} "#define BIAS - 0.01")
    says(2 "shadow.metal:6:" ${metal} "#define BIAS - offset")
endif()
in_a_project(with_program "Passed;Failed;Failed;Passed")

file(RENAME ${WORK}/moved/bin/umbrage-check ${WORK}/moved/bin/elsewhere)
in_a_project(without_program "Skipped;Skipped;Skipped;Skipped")
