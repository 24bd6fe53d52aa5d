# SPDX-License-Identifier: MIT
#
# A page's program prints what the page says it prints.
cmake_minimum_required(VERSION 3.21)
execute_process(COMMAND ${PROGRAM} ${PAGE} ${FOLDER} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PRINTED} printed)
string(FIND "${output}" "${printed}" found)
if(found EQUAL -1)
    message(FATAL_ERROR "It prints\n${output}\nThe page has\n${printed}")
endif()
