# SPDX-License-Identifier: MIT
#
# Prints the time to compile a file that includes umbrage.hpp, and one that includes what umbrage.hpp itself does.
# Medians of several turns, the two taken alternately; prints only, a slow machine fails nothing.
set(single_header ${CMAKE_CURRENT_LIST_DIR}/../../single_include/umbrage/umbrage.hpp)
file(STRINGS ${single_header} base REGEX "^#include <")
list(JOIN base "\n" base)
file(WRITE with.cpp "#include <umbrage/umbrage.hpp>\n")
file(WRITE base.cpp "${base}\n")

set(turns 7)
math(EXPR middle "${turns} / 2")
foreach(turn RANGE ${turns}) # one more: the first warms up
    foreach(file with base)
        string(TIMESTAMP start "%s%f")
        execute_process(COMMAND ${CXX} -c ${file}.cpp -o ${file}.o COMMAND_ERROR_IS_FATAL ANY)
        string(TIMESTAMP end "%s%f")
        math(EXPR ms "(${end} - ${start} + 500) / 1000")
        if(turn GREATER 0)
            list(APPEND ${file}_ms ${ms})
        endif()
    endforeach()
endforeach()
foreach(file with base)
    list(SORT ${file}_ms COMPARE NATURAL)
    list(GET ${file}_ms ${middle} ${file})
endforeach()
math(EXPR percent "(${with} * 100 + ${base} / 2) / ${base}")
string(REGEX REPLACE "(..)$" ".\\1" ratio ${percent})
message("umbrage.hpp ${with} ms, the GLM and standard headers it includes ${base} ms: ${ratio} times, medians of ${turns}")
