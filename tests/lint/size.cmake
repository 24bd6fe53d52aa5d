# SPDX-License-Identifier: MIT
#
# Fails when a C++ file has more than 300 lines or 120 columns: what does not fit is two ideas. A header of the library
# may have 350, sooner than a class is cut against sense.
cmake_minimum_required(VERSION 3.21)
string(REPEAT . 121 too_long)

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/include/*.[ch]pp ${ROOT}/tests/*.[ch]pp
    ${ROOT}/examples/*.[ch]pp)
list(LENGTH files count)
if(count LESS 100)
    message(FATAL_ERROR "Only ${count} files in ${ROOT}")
endif()
foreach(file IN LISTS files)
    file(READ ${ROOT}/${file} text)
    string(REGEX MATCHALL "\n" lines "${text}")
    list(LENGTH lines lines)
    set(limit 300)
    if(file MATCHES "^include/")
        set(limit 350)
    endif()
    if(lines GREATER limit)
        message(SEND_ERROR "${file} has ${lines} lines, more than ${limit}")
    endif()
    file(STRINGS ${ROOT}/${file} long REGEX "${too_long}")
    foreach(line IN LISTS long)
        message(SEND_ERROR "${file} has more than 120 columns:\n${line}")
    endforeach()
endforeach()
