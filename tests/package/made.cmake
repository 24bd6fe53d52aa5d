# SPDX-License-Identifier: MIT
#
# Fails when the committed package is not what the programs write.
file(REMOVE_RECURSE ${MADE})
execute_process(COMMAND ${WRITER} ${SOURCE} ${MADE} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE made RELATIVE ${MADE} ${MADE}/*)
file(GLOB_RECURSE committed RELATIVE ${COMMITTED} ${COMMITTED}/shaders/* ${COMMITTED}/*.mjs ${COMMITTED}/*.mts
     ${COMMITTED}/LICENSE)
list(FILTER committed EXCLUDE REGEX "^(npm|wasm)/") # by hand, and by wasm.mjs
if(NOT made STREQUAL committed)
    message(FATAL_ERROR "${COMMITTED} has files too many or too few; write them anew: cmake --build --preset dev --target single_include")
endif()
foreach(name IN LISTS made)
    file(SHA256 ${MADE}/${name} one)
    file(SHA256 ${COMMITTED}/${name} other)
    if(NOT one STREQUAL other)
        message(FATAL_ERROR "${COMMITTED}/${name} is stale; write it anew: cmake --build --preset dev --target single_include")
    endif()
endforeach()
list(LENGTH made count)
message(STATUS "${count} files as committed")
