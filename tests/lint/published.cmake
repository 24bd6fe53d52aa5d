# SPDX-License-Identifier: MIT
#
# Fails when something that is published or installed includes a file of tests/ or examples/: headers of the library, and all of
# single_include, with the npm package's sources. What they include is a system header, GLM, this library, or lies beside them.
#
#     cmake -D ROOT=source-folder -P published.cmake
cmake_minimum_required(VERSION 3.21)
set(count 0)

# check(FILE INCLUDE): INCLUDE, relative to FILE, lies in single_include.
function(check file include)
    cmake_path(GET file PARENT_PATH folder)
    cmake_path(ABSOLUTE_PATH include BASE_DIRECTORY ${folder} NORMALIZE)
    cmake_path(IS_PREFIX published ${include} inside)
    string(REGEX REPLACE "[.]mjs$" ".d.mts" types ${include})
    if(include MATCHES "/npm/source/" AND NOT file MATCHES "/npm/source/") # which the tarball leaves out
        set(inside FALSE)
    endif()
    if(NOT inside OR NOT (EXISTS ${include} OR EXISTS ${types}))
        message(SEND_ERROR "${file} includes ${include}, which is not published beside it")
    endif()
endfunction()

file(GLOB_RECURSE sources ${ROOT}/include/*.hpp ${ROOT}/single_include/*.[ch]pp)
set(published ${ROOT}/single_include)
foreach(file IN LISTS sources)
    file(STRINGS ${file} includes REGEX "^ *# *include ")
    foreach(include IN LISTS includes)
        math(EXPR count "${count} + 1")
        if(include MATCHES "include \"([^\"]+)\"")
            check(${file} ${CMAKE_MATCH_1})
        elseif(NOT include MATCHES "include <(umbrage/[a-z0-9_/]+[.]hpp|glm/[a-z0-9_/]+[.]hpp|[a-z0-9_]+([.]h)?|C[+][+]20)>")
            message(SEND_ERROR "${file} includes what is neither the language's, GLM nor of this library: ${include}")
        endif()
    endforeach()
endforeach()

file(GLOB_RECURSE modules ${ROOT}/single_include/*.m[jt]s)
list(FILTER modules EXCLUDE REGEX "/npm/source/templates/") # written one floor up, and checked there
foreach(file IN LISTS modules)
    file(STRINGS ${file} imports REGEX "(^|[^a-z])(from|import)[ (]+'[^']+'")
    foreach(import IN LISTS imports)
        math(EXPR count "${count} + 1")
        string(REGEX MATCH "(from|import)[ (]+'([^']+)'" unused "${import}")
        set(name "${CMAKE_MATCH_2}")
        if(name MATCHES "^[.]")
            check(${file} ${name})
        elseif(NOT name MATCHES "^(node:[a-z_]+|umbrage(/[a-z]+)*|three(/[a-z]+)?|playcanvas|@babylonjs/core(/[A-Za-z.0-9/]+)?)$")
            message(SEND_ERROR "${file} imports what is neither an engine nor of this package: ${import}")
        endif()
    endforeach()
endforeach()

# What builds them names no such folder.
file(GLOB builders ${ROOT}/single_include/*.cmake ${ROOT}/single_include/npm/source/*.mjs ${ROOT}/single_include/npm/source/CMakeLists.txt)
foreach(file IN LISTS builders)
    file(STRINGS ${file} lines REGEX "[/' ](tests|examples)[/' ]")
    list(FILTER lines EXCLUDE REGEX "^ *(#|//)")
    if(lines)
        message(SEND_ERROR "${file} takes something of tests/ or examples/: ${lines}")
    endif()
endforeach()

list(LENGTH modules modules)
if(count LESS 1000 OR modules LESS 40)
    message(FATAL_ERROR "${count} includes read, of ${modules} modules among others: does this test still find them?")
endif()
message(STATUS "${count} includes, none of tests/ or examples/")
