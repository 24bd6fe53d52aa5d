# SPDX-License-Identifier: MIT
#
# Tests of your shaders against C++, from find_package(umbrage):
#
#     umbrage_check_shader(shadow.frag CALL "shadow(map, uv, z)" IS pcf_2x2)
#
# The test is named after the file and the call, or by NAME. With EXACT the bits must be the same. ARGUMENTS gives further
# options of umbrage-check. Where the program is not installed the test counts as skipped.
function(umbrage_check_shader file)
    find_program(UMBRAGE_CHECK umbrage-check HINTS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../../bin
                 DOC "umbrage-check, which is built with UMBRAGE_BUILD_CHECK")
    cmake_parse_arguments(PARSE_ARGV 1 check "EXACT" "NAME;CALL;IS;ON" "ARGUMENTS")
    if(check_UNPARSED_ARGUMENTS OR NOT check_CALL)
        message(FATAL_ERROR "umbrage_check_shader(FILE CALL expression [IS name] [ON where] [EXACT] [NAME name] [ARGUMENTS ...]), "
                            "not ${ARGV}")
    endif()
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE path)
    if(NOT check_NAME)
        set(check_NAME "${file}: ${check_CALL}")
    endif()
    set(command ${UMBRAGE_CHECK} ${path} --call ${check_CALL} ${check_ARGUMENTS})
    if(check_IS)
        list(APPEND command --is ${check_IS})
    endif()
    if(check_ON)
        list(APPEND command --on ${check_ON})
    endif()
    if(check_EXACT)
        list(APPEND command --exact)
    endif()
    if(NOT UMBRAGE_CHECK)
        set(command ${CMAKE_COMMAND} -E echo "SKIPPED: needs umbrage-check")
    endif()
    add_test(NAME ${check_NAME} COMMAND ${command})
    set_tests_properties(${check_NAME} PROPERTIES SKIP_REGULAR_EXPRESSION "^SKIPPED: ")
endfunction()
