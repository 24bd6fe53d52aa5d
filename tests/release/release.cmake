# SPDX-License-Identifier: MIT
#
# Writes what a release attaches, with SHA256SUMS: the single headers, the shader texts, the npm tarball, a Debian
# package and the full test vectors. All generated files are generated again; the same sources give the same bytes.
#
#     cmake -D UMBRAGE=source-folder -D CXX=g++ -D OUT=folder -P release.cmake
cmake_minimum_required(VERSION 3.21)
foreach(tool tar npm cpack dpkg-deb)
    find_program(found_${tool} ${tool} REQUIRED)
endforeach()
get_filename_component(UMBRAGE ${UMBRAGE} ABSOLUTE)
get_filename_component(OUT ${OUT} ABSOLUTE)
file(STRINGS ${UMBRAGE}/include/umbrage/version.hpp version REGEX "^#define UMBRAGE_VERSION_")
list(TRANSFORM version REPLACE "[^0-9]+" "")
list(JOIN version "." version)

function(run folder)
    execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# A copy of the sources, whose generated files are removed first.
set(work ${OUT}/work)
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${work})
foreach(part CMakeLists.txt LICENSE include single_include)
    get_filename_component(parent ${work}/${part} DIRECTORY)
    file(COPY ${UMBRAGE}/${part} DESTINATION ${parent})
endforeach()
set(single ${work}/single_include)
file(REMOVE_RECURSE ${single}/module ${single}/shaders ${single}/umbrage)
run(${work} ${CMAKE_COMMAND} -P single_include/amalgamate.cmake)
run(${work} ${CXX} -std=c++20 -O0 -I include single_include/npm/source/write_package.cpp -o write_package)
run(${work} ./write_package single_include/npm/source single_include)

# Archives without owners, times or an order of the file system.
set(archive tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX --use-compress-program "gzip -n")
run(${single} ${archive} -cf ${OUT}/umbrage-${version}-single-header.tar.gz umbrage LICENSE)
run(${single} ${archive} -cf ${OUT}/umbrage-${version}-shaders.tar.gz shaders LICENSE)
run(${OUT} npm pack ${single} --silent)
file(RENAME ${OUT}/umbrage-${version}.tgz ${OUT}/umbrage-${version}-npm.tgz)
run(${work} ${CMAKE_COMMAND} -S . -B build -D CMAKE_CXX_COMPILER=${CXX})
run(${work}/build ${CMAKE_COMMAND} -E env SOURCE_DATE_EPOCH=0 cpack)
file(GLOB package ${work}/build/*.deb)
file(COPY ${package} DESTINATION ${OUT})

# The vectors, with more inputs than the committed file has, and their readers.
run(${work} ${CMAKE_COMMAND} -S ${UMBRAGE} -B suite -D CMAKE_CXX_COMPILER=${CXX} -D UMBRAGE_BUILD_TESTS=ON)
run(${work} ${CMAKE_COMMAND} --build suite --parallel --target vectors)
foreach(name README.md read.mjs read.py)
    file(COPY ${UMBRAGE}/tests/vectors/${name} DESTINATION ${work}/vectors)
endforeach()
run(${work} suite/tests/vectors/vectors vectors/tier_a.json 1024)
run(${work} ${archive} -cf ${OUT}/umbrage-${version}-vectors.tar.gz vectors LICENSE)
file(REMOVE_RECURSE ${work})

file(GLOB attached RELATIVE ${OUT} ${OUT}/*)
set(sums "")
foreach(name IN LISTS attached)
    file(SHA256 ${OUT}/${name} sum)
    string(APPEND sums "${sum}  ${name}\n")
endforeach()
file(WRITE ${OUT}/SHA256SUMS "${sums}")
message("${sums}")
