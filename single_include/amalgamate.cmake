# SPDX-License-Identifier: MIT
#
# Writes what is made of the headers: include/umbrage/primitives.hpp, which includes those of the primitives; and the single
# header, umbrage.hpp with each of our headers put in place once and the others' hoisted.
#
#     cmake -P single_include/amalgamate.cmake                  # or: cmake --build --preset dev --target single_include
#     cmake -D OUTPUT=folder -P single_include/amalgamate.cmake # the test: elsewhere, and compare
cmake_minimum_required(VERSION 3.21)

cmake_path(SET root NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/..)
set(committed ${CMAKE_CURRENT_LIST_DIR}/umbrage)
if(NOT OUTPUT)
    set(OUTPUT ${committed})
endif()

# write(FILE TEXT): leaves a file alone that has the text already, so that nothing is built anew for it.
function(write file text)
    file(WRITE ${file}.new "${text}")
    file(COPY_FILE ${file}.new ${file} ONLY_IF_DIFFERENT)
    file(REMOVE ${file}.new)
endfunction()

# made(NAME in FOLDER as committed in FOLDER): fails where the two differ.
function(made name new old)
    execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${new}/${name} ${old}/${name} RESULT_VARIABLE different)
    if(different)
        message(FATAL_ERROR "${old}/${name} is stale; make it anew:\n  cmake --build --preset dev --target single_include")
    endif()
endfunction()

# The primitives: every header but those of whole images, which bring simd/ along, those that make texts, the lists of
# kinds, which tools walk, other programs' formats, and those that fit lights to a scene or keep account of what they
# drew: geometry and containers, which take their time to compile.
file(GLOB_RECURSE primitives RELATIVE ${root}/include ${root}/include/*.hpp)
list(FILTER primitives EXCLUDE REGEX "/(draw|images|simd|shader|shadow|warp|foreign)/|/debug/overlay\\.|/(umbrage|primitives|registry|list|[a-z]*(filters|encodings))\\.hpp$")
list(FILTER primitives EXCLUDE REGEX "/light/([a-z]+_fit|bounds|light_choice|pixels_per_texel|sweep|cascades/(cascades|scene_depths|warped)|adaptive/(pages|root))\\.hpp$")
list(SORT primitives)
list(TRANSFORM primitives REPLACE "(.+)" "#include <\\1>\n")
list(JOIN primitives "" primitives)
set(folder ${root}/include/umbrage)
if(NOT OUTPUT STREQUAL "${committed}")
    set(folder ${OUTPUT})
endif()
write(${folder}/primitives.hpp "// SPDX-License-Identifier: MIT
//
// The primitives of umbrage alone, for short compile times. <umbrage/umbrage.hpp>, or headers of their own, have the
// rest: shadows as one object, functions over whole images with the depth pass, fitted lights (`directional_fit`,
// `spot_fit`, cascades, warp, adaptive), other programs' formats (depth/foreign), lists of encodings and filters, and
// texts of snippets. Made by single_include/amalgamate.cmake.
#pragma once

${primitives}")
made(primitives.hpp ${folder} ${root}/include/umbrage)

set(done "")   # our headers, in the order in which they were reached
set(others "") # GLM and standard headers
set(body "")
file(READ ${root}/LICENSE licence)
string(REGEX REPLACE "\n" "\n// " licence "// ${licence}")
string(REGEX REPLACE " +\n" "\n" licence "${licence}\n")

# A macro, so that these lists are the only state.
macro(put_in header)
    list(APPEND done ${header})
    file(READ ${root}/include/${header} text_of_${header})
    # Conditional includes stay where they are.
    string(REGEX REPLACE "(\n#(if|else|error)[^\n]*\n#) *include" "\\1 include" text_of_${header} "${text_of_${header}}")
    string(REGEX MATCHALL "\n#include <[^>]+" includes "${text_of_${header}}")
    list(TRANSFORM includes REPLACE "\n#include <" "")
    foreach(include IN LISTS includes)
        if(NOT include MATCHES "^umbrage/")
            list(APPEND others ${include})
        elseif(NOT include IN_LIST done)
            put_in(${include})
        endif()
    endforeach()
    # By name again: reaching deeper has changed every other variable.
    string(REGEX REPLACE "\n#(pragma once|include <[^>]+>)[^\n]*" "" text "${text_of_${header}}")
    string(REGEX REPLACE "^// SPDX[^\n]*\n(//\n)?" "" text "${text}")
    string(REGEX REPLACE "\n\n\n+" "\n\n" text "${text}")
    string(APPEND body "\n// ---- ${header}\n${text}")
endmacro()
put_in(umbrage/umbrage.hpp)
list(REMOVE_DUPLICATES others)
list(SORT others)
list(TRANSFORM others REPLACE "(.+)" "#include <\\1>\n")
list(JOIN others "" others)
write(${OUTPUT}/umbrage.hpp "// SPDX-License-Identifier: MIT
//
// All of umbrage in one file, made by single_include/amalgamate.cmake: do not edit.
//
${licence}
#pragma once

${others}${body}")
made(umbrage.hpp ${OUTPUT} ${committed})

file(GLOB_RECURSE headers RELATIVE ${root}/include ${root}/include/*.hpp)
foreach(header IN LISTS headers)
    if(NOT header IN_LIST done)
        message(SEND_ERROR "Nothing includes ${header}: add it to include/umbrage/umbrage.hpp, whose includes are sorted")
    endif()
endforeach()
