// SPDX-License-Identifier: MIT
//
// Prints the GLSL text of the two-channel encodings, its floats called half, for mediump.hpp to compile.
#include <cstdio>
#include <string>

#include <umbrage/depth/rg.hpp>
#include <umbrage/shader/glsl.hpp>

int main() {
    using namespace umbrage::glsl;
    std::string glsl = text({to_unorm, encode_rg<9>, encode_rg<10>, encode_rg<11>, encode_rg<12>, encode_rg<13>,
                             decode_rg<9>, decode_rg<10>, decode_rg<11>, decode_rg<12>, decode_rg<13>});
    for (std::size_t at; (at = glsl.find("float ")) != std::string::npos;) glsl.replace(at, 5, "half");
    std::puts(glsl.c_str());
}
