# SPDX-License-Identifier: MIT
#
# Compiles the library after a header that defines macros as windows.h and X11 do: first of all, and behind GLM and the
# standard library, which undefine some.
#
#     cmake -D CXX=... -D FLAGS=... -D UMBRAGE=source-folder -P macros.cmake
file(GLOB_RECURSE headers ${UMBRAGE}/include/umbrage/*.hpp)
set(others)
foreach(header IN LISTS headers)
    file(STRINGS ${header} lines REGEX "^#include <(glm/|[a-z_]+>)")
    list(APPEND others ${lines})
endforeach()
list(REMOVE_DUPLICATES others)
list(JOIN others "\n" others)
set(macros "#include \"${CMAKE_CURRENT_LIST_DIR}/macros.hpp\"")

foreach(header IN ITEMS include/umbrage/primitives.hpp single_include/umbrage/umbrage.hpp)
    string(REGEX REPLACE "/umbrage/.*" "" folder ${header})
    foreach(before IN ITEMS "" "${others}")
        file(WRITE macros.cpp "${before}\n${macros}\n#include \"${UMBRAGE}/${header}\"\n")
        execute_process(COMMAND ${CXX} -fsyntax-only -I${UMBRAGE}/${folder} ${FLAGS} macros.cpp RESULT_VARIABLE result)
        if(result)
            message(SEND_ERROR "${CXX}: ${header} does not compile after macros.hpp")
        endif()
    endforeach()
endforeach()
