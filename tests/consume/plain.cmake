# SPDX-License-Identifier: MIT
#
# Configures, builds and installs as a packager does, with no options. Nothing is compiled: tests and examples are built
# only when asked for.
#
#     cmake -D UMBRAGE=source-folder -D GENERATOR=Ninja -D CXX=g++ -D PREFIX=where-to -P plain.cmake
file(REMOVE_RECURSE plain)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${UMBRAGE} -B plain -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
                COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE lists plain/cmake_install.cmake)
list(LENGTH lists folders)
if(folders GREATER 1)
    message(FATAL_ERROR "A plain configure takes folders in besides the library: ${lists}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build plain COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install plain --prefix ${PREFIX} COMMAND_ERROR_IS_FATAL ANY)

# Headers are installed, the pages beside them are not.
file(GLOB_RECURSE headers ${PREFIX}/*/umbrage/*.hpp)
file(GLOB_RECURSE pages ${PREFIX}/*.md)
if(NOT headers OR pages)
    message(FATAL_ERROR "Headers are missing, or pages are installed: ${pages}")
endif()
