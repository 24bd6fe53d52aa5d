# SPDX-License-Identifier: MIT
add_executable(check_engine $<TARGET_OBJECTS:umbrage_test_main> trial/engine.cpp trial/bounds.cpp)
target_link_libraries(check_engine PRIVATE umbrage_test_flags umbrage_check_engine)
target_precompile_headers(check_engine REUSE_FROM umbrage_test_headers)
add_doctest(check/engine COMMAND check_engine)

set(parts slips codec_slips rewrites snippets words)
list(TRANSFORM parts REPLACE "(.+)" "trial/\\1.cpp" OUTPUT_VARIABLE texts)
add_executable(check_shaders $<TARGET_OBJECTS:umbrage_test_main> ${texts})
target_link_libraries(check_shaders PRIVATE umbrage_test_flags umbrage_check_program)
find_package(glslang QUIET)
umbrage_test(check/installed NEEDS UMBRAGE_EGL UMBRAGE_VULKAN_HEADERS glslang::SPIRV UMBRAGE_NODE
             COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR} -D MODULES=${UMBRAGE_NODE_MODULES}
                     -D WORK=${CMAKE_CURRENT_BINARY_DIR}/installed -P ${CMAKE_CURRENT_SOURCE_DIR}/installed.cmake)
set_tests_properties(check/installed PROPERTIES ENVIRONMENT "LIBGL_ALWAYS_SOFTWARE=true;MESA_SHADER_CACHE_DISABLE=true")
foreach(part IN LISTS parts)
    add_doctest(check/${part} COMMAND check_shaders --source-file=*/trial/${part}.cpp)
    set_tests_properties(check/${part} PROPERTIES ENVIRONMENT "${quick_mesa}")
endforeach()
add_custom_target(prove_check
    COMMAND ${CMAKE_COMMAND} -E env UMBRAGE_ALL_ROUNDS=1 ${quick_mesa} $<TARGET_FILE:check_shaders> --source-file=*slips.cpp
    USES_TERMINAL)
