# SPDX-License-Identifier: MIT
#
# Makes a release twice, in two folders, by two compilers, in two locales and time zones. Fails where a byte differs.
#
#     cmake -D UMBRAGE=source-folder -D CXX=g++ -D OTHER_CXX=clang++-14 -D WORK=folder -P again.cmake
cmake_minimum_required(VERSION 3.21)
get_filename_component(WORK ${WORK} ABSOLUTE)

function(release folder compiler locale zone)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=${locale} TZ=${zone} ${CMAKE_COMMAND} -D UMBRAGE=${UMBRAGE}
                            -D CXX=${compiler} -D OUT=${WORK}/${folder} -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/release.cmake
                    COMMAND_ERROR_IS_FATAL ANY)
    file(READ "${WORK}/${folder}/SHA256SUMS" sums)
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
