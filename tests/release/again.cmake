# SPDX-License-Identifier: MIT
#
# Makes a release twice, in two copies of the sources under other paths, by two compilers, in two locales and time zones.
# Fails where a byte differs.
#
#     cmake -D UMBRAGE=source-folder -D CXX=g++ -D OTHER_CXX=clang++-14 -D WORK=folder -P again.cmake
cmake_minimum_required(VERSION 3.21)
get_filename_component(WORK ${WORK} ABSOLUTE)
file(REMOVE_RECURSE ${WORK})

function(release copy compiler locale zone)
    set(folder "${WORK}/${copy}")
    foreach(part CMakeLists.txt LICENSE include single_include tests/package tests/release)
        get_filename_component(parent "${folder}/${part}" DIRECTORY)
        file(COPY ${UMBRAGE}/${part} DESTINATION ${parent})
    endforeach()
    execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=${locale} TZ=${zone} ${CMAKE_COMMAND} -D UMBRAGE=${folder} -D CXX=${compiler}
                            -D OUT=${folder}/out -P ${folder}/tests/release/release.cmake COMMAND_ERROR_IS_FATAL ANY)
    file(READ ${folder}/out/SHA256SUMS sums)
    set(sums "${sums}" PARENT_SCOPE)
endfunction()

release(one ${CXX} C UTC)
set(first "${sums}")
execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 2)
release("another place/two" ${OTHER_CXX} C.UTF-8 Asia/Tokyo)
if(NOT first STREQUAL sums)
    message(FATAL_ERROR "The releases differ:\n${first}\n${sums}")
endif()
message("The same bytes, by ${CXX} and by ${OTHER_CXX}.")
