# SPDX-License-Identifier: MIT
#
# Packs what plain.cmake configured as a Debian package, and unpacks it as dpkg would.
#
#     cmake -D BUILD=plain -D PREFIX=where-to -P debian.cmake
file(GLOB before ${BUILD}/*.deb)
if(before)
    file(REMOVE ${before})
endif()
execute_process(COMMAND cpack -G DEB WORKING_DIRECTORY ${BUILD} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package ${BUILD}/libumbrage-dev_*_all.deb)
execute_process(COMMAND dpkg-deb --field ${package} Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
if(NOT depends MATCHES "libglm-dev")
    message(FATAL_ERROR "The package depends on ${depends}, not on libglm-dev")
endif()
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND dpkg-deb --extract ${package} ${PREFIX} COMMAND_ERROR_IS_FATAL ANY)
