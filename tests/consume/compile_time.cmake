# SPDX-License-Identifier: MIT
#
# Prints what including umbrage.hpp and primitives.hpp costs, as a multiple of a file that includes glm.hpp and the
# standard headers that programs with shadow maps have anyway. User time, the median of several turns, taken alternately:
# systems tell it from their own by samples, so that the least is one that missed some. Prints only: no test hangs on a
# machine's time.
set(base_headers glm/glm.hpp array bit concepts cstdint span string vector)
list(TRANSFORM base_headers REPLACE "(.+)" "#include <\\1>\n")
list(JOIN base_headers "" base)
file(WRITE base.cpp "${base}")
file(WRITE primitives.cpp "#include <umbrage/primitives.hpp>\n")
file(WRITE umbrage.cpp "#include <umbrage/umbrage.hpp>\n")

# Milliseconds of processor time that a command takes.
function(user_time result)
    string(REPLACE ";" "' '" command "${ARGN}")
    execute_process(COMMAND bash -c "TIMEFORMAT=%3U; time '${command}'" ERROR_VARIABLE seconds COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCH "([0-9]+)\\.([0-9][0-9][0-9])" seconds "${seconds}")
    math(EXPR ms "${CMAKE_MATCH_1} * 1000 + 1${CMAKE_MATCH_2} - 1000")
    set(${result} ${ms} PARENT_SCOPE)
endfunction()

foreach(turn RANGE 1 ${TURNS})
    foreach(file base primitives umbrage)
        user_time(ms ${CXX} -c ${file}.cpp -o ${file}.o)
        list(APPEND ${file}_turns ${ms})
    endforeach()
endforeach()
math(EXPR middle "${TURNS} / 2")
foreach(file base primitives umbrage)
    list(SORT ${file}_turns COMPARE NATURAL)
    list(GET ${file}_turns ${middle} ${file}_ms)
endforeach()
message("glm.hpp and standard headers ${base_ms} ms, median of ${TURNS}")
foreach(file_limit primitives:3 umbrage:6)
    string(REGEX MATCH "(.*):(.*)" matched ${file_limit})
    set(file ${CMAKE_MATCH_1})
    set(limit ${CMAKE_MATCH_2})
    math(EXPR percent "(${${file}_ms} * 100 + ${base_ms} / 2) / ${base_ms}")
    string(REGEX REPLACE "(..)$" ".\\1" ratio ${percent})
    message("${file}.hpp ${${file}_ms} ms: ${ratio} times that, ${limit} intended")
endforeach()
