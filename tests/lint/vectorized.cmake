# SPDX-License-Identifier: MIT
#
# Fails when GCC leaves a loop over a block scalar on AVX2, which it does without a word: its report says which loops it
# made vectors of. Only loops in functions that vectorized.cpp.in uses are compiled, and looked at.
cmake_minimum_required(VERSION 3.21)
set(looked_at images/encode images/min_max images/summed_area images/visibility images/blocks/receivers
    images/blocks/pcf_2x2 shadow/place_blocks draw/raster/projection draw/raster/small_triangles
    draw/raster/triangles)
set(scalar # by intent: what a constructor sets once, and what a branch leaves out nearly always; or not used
    "images/blocks/receivers.hpp:.* (set[(]i, from|room.rows.0..i. = texels)"
    "draw/raster/projection.hpp:.* if [(]outside.i.[)] vertices"
    "draw/raster/triangles.hpp:.* id.i. = 0")

execute_process(COMMAND ${CXX} -O2 -DUMBRAGE_FORCE_ISA=avx2 -fopt-info-vec-optimized=vectorized.txt -x c++ -c ${SOURCE} -o vectorized.o
    RESULT_VARIABLE failed)
if(failed)
    message(FATAL_ERROR "${SOURCE} does not compile")
endif()
file(READ vectorized.txt report)

set(loops 0)
foreach(header IN LISTS looked_at)
    file(READ ${INCLUDE}/umbrage/${header}.hpp text)
    string(REGEX REPLACE "[][;]" "." text "${text}")
    string(REPLACE "\n" ";" lines "${text};")
    set(number 0)
    foreach(line IN LISTS lines)
        math(EXPR number "${number} + 1")
        if(NOT line MATCHES "for .int i = 0. i < block. [+][+]i")
            continue()
        endif()
        list(GET lines ${number} next)
        set(intended FALSE)
        foreach(one IN LISTS scalar)
            if("${header}.hpp:${line}${next}" MATCHES "${one}")
                set(intended TRUE)
            endif()
        endforeach()
        math(EXPR loops "${loops} + 1")
        set(made "umbrage/${header}.hpp:${number}:[0-9]+: optimized: loop vectorized using 32 byte")
        if(NOT intended AND NOT report MATCHES "${made}")
            message(SEND_ERROR "include/umbrage/${header}.hpp:${number}: not vectorised for AVX2: ${line}")
        endif()
    endforeach()
endforeach()
if(loops LESS 15)
    message(FATAL_ERROR "Only ${loops} loops over blocks: does this test still find them?")
endif()
