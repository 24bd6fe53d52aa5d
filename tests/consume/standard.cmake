# SPDX-License-Identifier: MIT
#
# A compiler without C++20 says so, and stops there, whichever header a user includes.
#
#     cmake -D CXX=... [-D OTHER_CXX=...] -D FLAGS=... -D UMBRAGE=source-folder -P standard.cmake
list(REMOVE_ITEM FLAGS -std=c++20)
if(NOT OTHER_CXX)
    set(OTHER_CXX)
endif()
foreach(header IN ITEMS include/umbrage/umbrage.hpp include/umbrage/primitives.hpp include/umbrage/depth/encodings.hpp
        include/umbrage/filter/filter.hpp single_include/umbrage/umbrage.hpp)
    string(REGEX REPLACE "/umbrage/.*" "" folder ${header})
    file(WRITE standard.cpp "#include \"${UMBRAGE}/${header}\"\nauto texel = umbrage::encode_rg<11>(0.5f);\n")
    foreach(compiler IN ITEMS ${CXX} ${OTHER_CXX})
        execute_process(COMMAND ${compiler} -fsyntax-only -I${UMBRAGE}/${folder} ${FLAGS} -std=c++17 standard.cpp
                        RESULT_VARIABLE failed ERROR_VARIABLE said)
        string(REGEX MATCHALL "error:" errors "${said}")
        list(LENGTH errors count)
        if(NOT failed OR count GREATER 2 OR NOT said MATCHES "umbrage needs C") # the second error is the stop
            string(SUBSTRING "${said}" 0 2000 said)
            message(SEND_ERROR "${compiler}: ${header} as C++17 gives ${count} errors, not that it needs C++20\n${said}")
        endif()
    endforeach()
endforeach()
