# SPDX-License-Identifier: MIT
#
# Holds what is fetched to tests/fetched.md: every package has one version, which the page lists.
#
#     cmake -D ROOT=source-folder -P fetched.cmake
file(READ ${ROOT}/tests/fetched.md page)
file(GLOB_RECURSE lists ${ROOT}/tests/CMakeLists.txt ${ROOT}/tests/run)
set(failed FALSE)
set(count 0)
foreach(file IN LISTS lists ITEMS ${ROOT}/.ci/install)
    file(READ ${file} text)
    string(REGEX MATCHALL "@?[a-z][a-z0-9-]*(/[a-z0-9-]+)?@(latest|next|[0-9]+[.][0-9]+[.][0-9]+)" fetched "${text}")
    foreach(package IN LISTS fetched)
        math(EXPR count "${count} + 1")
        string(REGEX MATCH "^(.+)@([^@]+)$" unused ${package})
        string(FIND "${page}" "${CMAKE_MATCH_1}" name)
        string(FIND "${page}" "${CMAKE_MATCH_2}" version)
        if(name EQUAL -1 OR version EQUAL -1)
            message("${file}: fetches ${package}, which tests/fetched.md does not list")
            set(failed TRUE)
        endif()
    endforeach()
endforeach()
if(failed OR count LESS 10)
    message(FATAL_ERROR "${count} packages read")
endif()
