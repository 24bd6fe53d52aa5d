# SPDX-License-Identifier: MIT
#
# Compiles programs with GLM's settings and with warnings as strict projects have them.
#
#     cmake -D COMPILERS=... -D FLAGS=... -D UMBRAGE=source-folder -P flags.cmake
function(compile result compiler source)
    execute_process(COMMAND ${compiler} -fsyntax-only -I${UMBRAGE}/include ${FLAGS} ${ARGN} ${UMBRAGE}/tests/${source}
                    RESULT_VARIABLE code ERROR_VARIABLE said)
    set(${result} ${code} PARENT_SCOPE)
    set(said "${said}" PARENT_SCOPE)
endfunction()

set(explicit -DGLM_FORCE_EXPLICIT_CTOR)
set(strict -DGLM_FORCE_CTOR_INIT -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror)
set(kinds explicit strict)  # of which the first says nothing new from a second compiler
foreach(compiler IN LISTS COMPILERS)
    foreach(flags IN LISTS kinds)
        foreach(source IN ITEMS consume/project/images.cpp consume/project/main.cpp proof/hostile/fits.cpp)
            compile(failed ${compiler} ${source} ${${flags}})
            if(failed)
                message(SEND_ERROR "${compiler} ${${flags}}: ${source} does not compile\n${said}")
            endif()
        endforeach()
    endforeach()
    set(kinds strict)
    compile(failed ${compiler} consume/project/main.cpp -DGLM_FORCE_CXX98)
    string(REGEX MATCH "error: [^\n]*" first "${said}")
    if(NOT first MATCHES "GLM_FORCE_CXX98")
        message(SEND_ERROR "${compiler} -DGLM_FORCE_CXX98: the first error does not say what is wrong\n${said}")
    endif()
endforeach()
