# SPDX-License-Identifier: MIT
#
# Sets suite_sources: every file of entries, one that lists them, and what makes their inputs and texts. Entries find
# their place by where their file lies: add_filter_pcf_box in entries/filter/pcf/box.cpp, and so on. With
# sample_of_entries, one file in eight.
file(GLOB_RECURSE names CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR}/entries ${CMAKE_CURRENT_LIST_DIR}/entries/*.cpp)
set(declarations "")
set(calls "")
set(entry_sources ${CMAKE_CURRENT_BINARY_DIR}/entries.cpp)
foreach(name IN LISTS names)
    string(MD5 hash ${name})
    if(sample_of_entries AND NOT hash MATCHES "^[01]")
        continue()
    endif()
    list(APPEND entry_sources ${CMAKE_CURRENT_LIST_DIR}/entries/${name})
    string(REGEX REPLACE "\\.cpp$" "" name ${name})
    string(REPLACE "/" "_" name ${name})
    string(APPEND declarations "void add_${name}(std::vector<entry>& all);\n")
    string(APPEND calls "    add_${name}(all);\n")
endforeach()
set(suite_sources ${entry_sources})
foreach(part IN ITEMS backends/block end_to_end/ray_light hlsl job shader texture values wgsl)
    list(APPEND suite_sources ${CMAKE_CURRENT_LIST_DIR}/${part}.cpp)
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/entries.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/entries.cpp @ONLY)
