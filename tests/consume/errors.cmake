# SPDX-License-Identifier: MIT
#
# Calls of visibility without an encoding, or with one of other texels than the map's: compilers show one function, whose line
# says what is wrong.
#
#     cmake -D CXX=... [-D OTHER_CXX=...] -D FLAGS=... -D UMBRAGE=source-folder -P errors.cmake
file(WRITE errors.cpp [[
#include <umbrage/umbrage.hpp>
using namespace umbrage;
void call(image_view<const float> map, image_view<const glm::vec3> receivers, image_view<float> out) {
    visibility(map, receivers, filters::pcf_2x2{}, out);
    visibility(map, filters::pcf_2x2{}, receivers, depth32f{}, out);
    visibility(map, rg<11>{}, receivers, filters::pcf_2x2{}, out);
}
]])
foreach(compiler IN ITEMS ${CXX} ${OTHER_CXX})
    execute_process(COMMAND ${compiler} -fsyntax-only -I${UMBRAGE}/include ${FLAGS} errors.cpp ERROR_VARIABLE said)
    string(REGEX MATCHALL "error: (use of|call to) deleted function" deleted "${said}")
    string(REGEX MATCHALL "error:" errors "${said}")
    string(REGEX MATCHALL "\n" lines "${said}")
    foreach(list IN ITEMS deleted errors lines)
        list(LENGTH ${list} ${list})
    endforeach()
    if(NOT deleted EQUAL 3 OR NOT errors EQUAL 3)
        message(SEND_ERROR "${compiler}: three wrong calls of visibility give ${errors} errors, not three short ones\n${said}")
    endif()
    foreach(sentence IN ITEMS "the second argument must be an encoding" "map must hold texels of the encoding")
        if(NOT said MATCHES "= delete;  ///< ${sentence}")
            message(SEND_ERROR "${compiler}: a wrong call of visibility does not show \"${sentence}\"\n${said}")
        endif()
    endforeach()
    if(said MATCHES "note: declared here" AND lines GREATER 30) # clang lists the other functions, too
        message(SEND_ERROR "${compiler}: three wrong calls of visibility give ${lines} lines\n${said}")
    endif()
endforeach()
