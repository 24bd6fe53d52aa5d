# SPDX-License-Identifier: MIT
#
# Holds the root to its four folders and its pages: what a program leaves there by hand is not committed.
#
#     cmake -D ROOT=source-folder -P root.cmake
file(GLOB found RELATIVE ${ROOT} ${ROOT}/*)
set(known include tests examples single_include CITATION.cff CMakeLists.txt CMakePresets.json CMakeUserPresets.json LICENSE Makefile)
set(strangers ${found})
list(FILTER strangers EXCLUDE REGEX "^([.].*|build.*|[A-Z]+[.]md)$")
list(REMOVE_ITEM strangers ${known})
list(LENGTH found count)
if(strangers OR count LESS 10)
    message(FATAL_ERROR "At the root, and not of it: ${strangers}")
endif()
