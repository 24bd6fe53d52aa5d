// SPDX-License-Identifier: MIT
//
// Digests of the results of every C++ twin for its entry's inputs, one line per entry. Compare two runs to find bits
// that changed.
//
//     parity_digest [COUNT]     name, number of inputs, digest; COUNT inputs of each map and of the enumeration, 2^16
#include <exception>

#include "digest.hpp"

int main(int argc, char** argv) try {
    const std::size_t count = argc > 1 ? std::stoul(argv[1]) : std::size_t(1) << 16;
    for (const parity::entry& e : parity::entries()) std::printf("%s\n", parity::digest_line(e, count).c_str());
} catch (const std::exception& error) {
    std::fprintf(stderr, "parity_digest: %s\n", error.what());
    return 2;
}
