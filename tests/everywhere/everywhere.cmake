# SPDX-License-Identifier: MIT
#
# Runs the library on every machine that a Debian machine can be, and compares digests of what it gives:
#
#     cmake -D HOSTILE=program -D GLM=/usr/include -D OUT=folder [-D CLANG=clang++-N] [-D SAMPLE=ON] -P everywhere.cmake
#
# tier_a     tier A's functions for hostile input, whatever the flags are
# images     functions over images
# twins      every C++ twin of tiers A, B and C for the inputs of tests/parity, in the written order of operations
#
# HOSTILE is the program of tests/proof/hostile/table.cpp, CLANG the newest clang here. A row says which compiler and
# flags, and what runs the programs. Compilers and emulators that this machine lacks are rows too, "not seen". The table
# is OUT/everywhere.md.
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
set(sample "")
set(inputs 16384) # of each of a twin's maps
if(SAMPLE)
    set(sample -DSAMPLE)
    set(inputs 2048)
endif()
file(MAKE_DIRECTORY ${OUT}/glm)
file(CREATE_LINK ${GLM}/glm ${OUT}/glm/glm SYMBOLIC) # alone: other headers there are none of a foreign machine's

# name | compiler | flags | what runs it | programs
set(all "tier_a images twins")
set(rows
    "x86-64, g++, as written|g++|-O2 -ffp-contract=off||${all}"
    "x86-64, g++, -Ofast|g++|-Ofast -march=native||tier_a images"
    "x86-64, oldest g++|g++-11|-O2||${all}"
    "x86-64, clang 14, libc++|clang++-14|-O2 -stdlib=libc++||${all}"
    "x86-64, newest clang|NEWEST_CLANG|-O3 -march=native -ffp-contract=off||twins"
    "x86-64, newest clang, -Ofast|NEWEST_CLANG|-O3 -ffast-math -march=native||tier_a images"
    "x86-64, SSE2 alone|g++|-O2 -DUMBRAGE_FORCE_ISA=base||images"
    "x86-64, AVX2|g++|-O2 -DUMBRAGE_FORCE_ISA=avx2||images"
    "x86-64, AVX-512|g++|-O2 -DUMBRAGE_FORCE_ISA=avx512||images"
    "x86, 32 bits, SSE2|i686-linux-gnu-g++|-static -O2 -msse2 -mfpmath=sse||${all}"
    "x86, 32 bits, x87|i686-linux-gnu-g++|-static -O2 -mno-sse -mfpmath=387||tier_a"
    "Windows, mingw-w64|x86_64-w64-mingw32-g++-posix|-static -O2|wine|${all}"
    "AArch64|aarch64-linux-gnu-g++|-static -O2|qemu-aarch64|${all}"
    "RISC-V, 64 bits|riscv64-linux-gnu-g++|-static -O2|qemu-riscv64|${all}"
    "IBM Z, big-endian|s390x-linux-gnu-g++|-static -O2|qemu-s390x|${all}"
    "WebAssembly|em++|-O2|node|${all}"
    "WebAssembly, SIMD|em++|-O2 -msimd128|node|tier_a images") # clang 14 draws the twins' inputs wrongly with it

file(STRINGS /proc/cpuinfo cpu REGEX "^flags" LIMIT_COUNT 1)
set(ENV{NODE_PATH} /usr/share/nodejs) # where Debian's emscripten finds acorn
set(ENV{WINEDEBUG} -all)
set(table "| machine, compiler | flags | tier A, hostile input | images | twins, tiers A to C |\n|---|---|---|---|---|\n")

# Builds a program of a row; `built` is what runs it, or empty.
function(build program name compiler flags runner)
    string(MAKE_C_IDENTIFIER "${program} ${name}" file)
    set(binary ${OUT}/${file})
    set(suffix "")
    if(compiler MATCHES "em\\+\\+$")
        string(APPEND flags " -sALLOW_MEMORY_GROWTH=1 -sENVIRONMENT=node -sEXIT_RUNTIME=1")
        string(APPEND runner " --no-experimental-fetch") # whose fetch emscripten would take for a browser's
        set(suffix .js)
    elseif(compiler MATCHES "mingw")
        set(suffix .exe)
    endif()
    set(arguments "")
    if(program STREQUAL twins)
        # Generic: of no machine whose flags CMake would add
        execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${root}/tests/everywhere/twins -B ${binary} -D CMAKE_SYSTEM_NAME=Generic
                -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags} -D CMAKE_EXECUTABLE_SUFFIX_CXX=${suffix}
                -D UMBRAGE_GLM=${OUT}/glm -D sample_of_entries=${SAMPLE}
            COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_QUIET)
        execute_process(COMMAND ${CMAKE_COMMAND} --build ${binary} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
        string(APPEND binary /twins)
        set(arguments ${inputs})
    else()
        separate_arguments(flags UNIX_COMMAND "${flags}")
        execute_process(COMMAND ${compiler} -std=c++20 -w ${flags} ${sample} -I${root}/include -isystem ${OUT}/glm
                ${root}/tests/proof/hostile/${program}.cpp -o ${binary}${suffix}
            RESULT_VARIABLE failed ERROR_VARIABLE said OUTPUT_QUIET)
    endif()
    if(failed)
        file(WRITE ${OUT}/${file}.log "${said}")
        set(built "" PARENT_SCOPE)
        return()
    endif()
    set(script "${OUT}/run/${program}, ${name}")
    file(WRITE "${script}" "#!/bin/sh\nexec ${runner} '${binary}${suffix}' ${arguments} | tr -d '\\r'\n")
    file(CHMOD "${script}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
    set(built "${script}" PARENT_SCOPE)
endfunction()

# Runs a program of a row beside its reference: `lines`, the number of the reference's digests, and how many `differ`.
function(compare program reference found log)
    if(program STREQUAL twins)
        foreach(which IN ITEMS reference found)
            execute_process(COMMAND "${${which}}" OUTPUT_FILE ${log}.${which})
            file(STRINGS ${log}.${which} ${which}_lines)
        endforeach()
        set(differing ${reference_lines})
        list(REMOVE_ITEM differing "" ${found_lines}) # "" where it printed nothing
        list(LENGTH reference_lines lines)
        list(LENGTH differing differ)
        string(REPLACE ";" "\n" differing "${differing}")
        file(WRITE ${log} "${differing}\n")
    else()
        execute_process(COMMAND ${HOSTILE} ${program} "${reference}" "${found}" RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
        file(WRITE ${log} "${said}")
        set(lines 0)
        set(differ 0)
        string(REGEX MATCHALL "[^\n]+ [0-9]+ +[0-9]+\n" both "${said}") # the reference's, then this build's
        list(LENGTH both count)
        if(count GREATER 1)
            list(GET both 1 line)
            string(REGEX MATCH " ([0-9]+) +([0-9]+)\n$" line "${line}")
            set(lines ${CMAKE_MATCH_1})
            set(differ ${CMAKE_MATCH_2})
        endif()
        if(failed AND differ EQUAL 0)
            set(lines 0)
        endif()
    endif()
    set(lines ${lines} PARENT_SCOPE)
    set(differ ${differ} PARENT_SCOPE)
endfunction()

set(bad FALSE)
foreach(row IN LISTS rows)
    string(REGEX MATCH "^([^|]*)[|]([^|]*)[|]([^|]*)[|]([^|]*)[|](.*)$" row "${row}")
    set(name "${CMAKE_MATCH_1}")
    set(compiler "${CMAKE_MATCH_2}")
    set(flags "${CMAKE_MATCH_3}")
    set(runner "${CMAKE_MATCH_4}")
    set(programs "${CMAKE_MATCH_5}")
    if(compiler STREQUAL NEWEST_CLANG)
        set(compiler "${CLANG}")
    endif()
    unset(found_compiler) # or the last one's stays
    unset(found_runner)
    find_program(found_compiler NAMES "${compiler}" NO_CACHE)
    if(runner)
        find_program(found_runner NAMES "${runner}" NO_CACHE)
    endif()
    set(why "")
    if(NOT compiler OR NOT found_compiler)
        set(why "not seen: no ${compiler} here")
    elseif(runner AND NOT found_runner)
        set(why "not seen: no ${runner}")
    elseif(flags MATCHES "ISA=avx2" AND NOT cpu MATCHES " avx2 ")
        set(why "not seen: no AVX2")
    elseif(flags MATCHES "ISA=avx512" AND NOT cpu MATCHES " avx512f ")
        set(why "not seen: no AVX-512")
    endif()
    foreach(program IN ITEMS tier_a images twins)
        if(NOT programs MATCHES ${program})
            set(${program}_said "")
        elseif(why)
            set(${program}_said "${why}")
        else()
            message(STATUS "${name}: ${program}")
            build(${program} "${name}" ${found_compiler} "${flags}" "${found_runner}")
            if(NOT built)
                set(${program}_said "does not compile")
                set(bad TRUE)
            elseif(NOT ${program}_reference)
                set(${program}_reference "${built}")
                set(${program}_said "the reference")
            else()
                string(MAKE_C_IDENTIFIER "${program} ${name}" file)
                compare(${program} "${${program}_reference}" "${built}" ${OUT}/${file}.log)
                if(lines EQUAL 0)
                    set(${program}_said "does not run")
                elseif(differ EQUAL 0)
                    set(${program}_said "${lines} digests, equal")
                else()
                    set(${program}_said "${differ} of ${lines} digests differ")
                endif()
                if(lines EQUAL 0 OR differ GREATER 0)
                    set(bad TRUE)
                endif()
            endif()
        endif()
    endforeach()
    string(APPEND table "| ${name} | `${flags}` | ${tier_a_said} | ${images_said} | ${twins_said} |\n")
endforeach()
file(WRITE ${OUT}/everywhere.md "${table}")
message("\n${table}")
if(bad)
    message(FATAL_ERROR "Something differs, or does not build: ${OUT}/*.log")
endif()
