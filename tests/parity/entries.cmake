# SPDX-License-Identifier: MIT
#
# Entries find their place by where their file lies: add_filter_pcf_box in entries/filter/pcf/box.cpp, and so on.
# Sets entry_sources.
set(folder ${CMAKE_CURRENT_LIST_DIR}/entries)
file(GLOB_RECURSE entry_sources CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.cpp)
set(declarations "")
set(calls "")
foreach(source IN LISTS entry_sources)
    string(REGEX REPLACE "\\.cpp$" "" name ${source})
    string(REPLACE "/" "_" name ${name})
    string(APPEND declarations "void add_${name}(std::vector<entry>& all);\n")
    string(APPEND calls "        add_${name}(all);\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/entries.cpp.in entries.cpp @ONLY)
list(TRANSFORM entry_sources PREPEND ${folder}/)
list(APPEND entry_sources ${CMAKE_CURRENT_BINARY_DIR}/entries.cpp)
