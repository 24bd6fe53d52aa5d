# SPDX-License-Identifier: MIT
#
# Compiles programs with GLM's settings and with warnings as strict projects have them. The newest clang's warnings are
# consume/newest_clang's.
#
#     cmake -D CXX=... -D FLAGS=... -D UMBRAGE=source-folder -P flags.cmake
function(compile result source)
    execute_process(COMMAND ${CXX} -fsyntax-only -I${UMBRAGE}/include ${FLAGS} ${ARGN} ${UMBRAGE}/tests/${source}
                    RESULT_VARIABLE code ERROR_VARIABLE said)
    set(${result} ${code} PARENT_SCOPE)
    set(said "${said}" PARENT_SCOPE)
endfunction()

set(explicit -DGLM_FORCE_EXPLICIT_CTOR)
set(strict -DGLM_FORCE_CTOR_INIT -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror)
foreach(flags IN ITEMS explicit strict)
    foreach(source IN ITEMS consume/project/images.cpp consume/project/main.cpp proof/hostile/fits.cpp)
        compile(failed ${source} ${${flags}})
        if(failed)
            message(SEND_ERROR "${${flags}}: ${source} does not compile\n${said}")
        endif()
    endforeach()
endforeach()
compile(failed consume/aligned.cpp -DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES -DGLM_FORCE_INTRINSICS)
if(failed)
    message(SEND_ERROR "-DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES: aligned.cpp does not compile\n${said}")
endif()
compile(failed consume/project/main.cpp -DGLM_FORCE_CXX98)
string(REGEX MATCH "error: [^\n]*" first "${said}")
if(NOT first MATCHES "GLM_FORCE_CXX98")
    message(SEND_ERROR "-DGLM_FORCE_CXX98: the first error does not say what is wrong\n${said}")
endif()
