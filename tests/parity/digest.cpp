// SPDX-License-Identifier: MIT
//
// Digests of the results of every C++ twin for its entry's inputs, one line per entry. Compare two runs to find bits
// that changed.
//
//     parity_digest [COUNT]     name, number of inputs, digest; COUNT inputs of each map and of the enumeration, 2^16
//
// -0 counts as 0 and every NaN as one. Inputs depend only on the entry and the number of its map, not on its position.
#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>

#include "../proof/hostile/hostile.hpp"
#include "backend.hpp"

namespace {

using namespace parity;

void add(hostile::digest& sum, const job& j) {
    for (std::size_t i = 0; i < j.count; ++i) {
        const vec4 result = j.what->twin(j.at(i));
        for (int c = 0; c < 4; ++c) sum(std::isnan(result[c]) ? std::numeric_limits<float>::quiet_NaN() : result[c]);
    }
}

}  // namespace

int main(int argc, char** argv) try {
    const std::size_t count = argc > 1 ? std::stoul(argv[1]) : std::size_t(1) << 16;
    for (const entry& e : entries()) {
        hostile::digest sum;
        std::size_t inputs = 0;
        const auto take = [&](const job& j) {
            add(sum, j);
            inputs += j.count;
        };
        if (e.maps.empty()) take(make_job(e, nullptr, 0, count, 0));
        for (const texels& map : e.maps)
            take(make_job(e, &map, 0, count, static_cast<std::uint64_t>(&map - e.maps.data())));
        if (e.whole.count) take(make_whole_job(e, 0, std::min<std::size_t>(count, e.whole.count), 0));
        std::printf("%s\t%zu\t%016" PRIx64 "\n", e.name().c_str(), inputs, sum.unsigned_zeros);
    }
} catch (const std::exception& error) {
    std::fprintf(stderr, "parity_digest: %s\n", error.what());
    return 2;
}
