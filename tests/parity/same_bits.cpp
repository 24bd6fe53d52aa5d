// SPDX-License-Identifier: MIT
//
//     same_bits LIBRARY [COUNT]     COUNT inputs of each map and of the enumeration, 2^14
//
// Compares what every C++ twin gives in this build with what it gives in the written order of operations, of the same
// inputs. Tier A must have the same bits. Entries of tier B and C whose bits differ are listed: this build's flags
// change them. -0 counts as 0 and every NaN as one.
#include <dlfcn.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include <umbrage/core/scalar.hpp>

#include "../proof/hostile/hostile.hpp"
#include "domain.hpp"
#include "written_order.hpp"

namespace {

using namespace parity;

std::uint32_t bits(float v) {
    const auto all = std::bit_cast<std::uint32_t>(v);
    return umbrage::is_nan(v) ? 0x7FC00000u : all == 0x80000000u ? 0u : all;
}

bool same(const vec4& a, const vec4& b) {
    bool all = true;
    for (int c = 0; c < 4; ++c) all = all && bits(a[c]) == bits(b[c]);
    return all;
}

/// The lowest tier of the snippets that the entry calls.
tier tier_of(const entry& e) {
    tier lowest = tier::a;
    for (const snippet& s : e.snippets()) lowest = std::max(lowest, s.exactness);
    return lowest;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) throw std::runtime_error("usage: same_bits LIBRARY [COUNT]");
    void* const library = ::dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::runtime_error(::dlerror());
    const auto* wanted = static_cast<const written_order*>(::dlsym(library, "written_order"));
    if (!wanted) throw std::runtime_error(::dlerror());
    hostile::set_flushing(false);  // -ffast-math links a start that flushes denormals, of which nothing is promised
    const std::size_t count = argc > 2 ? std::stoul(argv[2]) : std::size_t(1) << 14;

    int differ[3]{}, tried[3]{};
    for (std::size_t i = 0; i < entries().size(); ++i) {
        const entry &e = entries()[i], &other = wanted->entries().at(i);
        std::size_t inputs = 0, wrong = 0;
        const auto take = [&](const job& j) {
            for (std::size_t k = 0; k < j.count; ++k) wrong += !same(e.twin(j.at(k)), other.twin(j.at(k)));
            inputs += j.count;
        };
        if (e.maps.empty()) take(wanted->make_job(other, nullptr, 0, count, 0));
        for (std::size_t map = 0; map < e.maps.size(); ++map)
            take(wanted->make_job(other, &other.maps[map], 0, count, map));
        if (e.whole.count) take(wanted->make_whole_job(other, 0, std::min<std::size_t>(count, e.whole.count), 0));
        const auto t = static_cast<std::size_t>(tier_of(e));
        ++tried[t];
        if (!wrong) continue;
        std::printf("%c  %s: %zu of %zu%s\n", "ABC"[t], e.name().c_str(), wrong, inputs,
                    leaves_domain(e) ? ", of inputs beyond its domain" : "");
        differ[t] += !leaves_domain(e);
    }
    for (std::size_t t = 0; t < 3; ++t) std::printf("tier %c: %d of %d differ\n", "ABC"[t], differ[t], tried[t]);
    return differ[0] ? 1 : 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "same_bits: %s\n", error.what());
    return 2;
}
