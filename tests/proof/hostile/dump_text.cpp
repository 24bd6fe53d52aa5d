// SPDX-License-Identifier: MIT
//
// Prints the GLSL text of the two-channel encodings, for half.cpp to compile.
#include <cstdio>

#include <umbrage/depth/rg.hpp>

int main() {
    using namespace umbrage::glsl;
    std::puts(text({to_unorm, encode_rg<9>, encode_rg<10>, encode_rg<11>, encode_rg<12>, encode_rg<13>, decode_rg<9>,
                    decode_rg<10>, decode_rg<11>, decode_rg<12>, decode_rg<13>})
                  .c_str());
}
