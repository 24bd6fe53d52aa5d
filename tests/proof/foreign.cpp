// SPDX-License-Identifier: MIT
//
// Formats of others over every depth of 24 bits: their worst errors and faults are what the headers state, no more and
// no less. All floats: `make prove`.
#include <doctest/doctest.h>

#include "codecs.hpp"

TEST_CASE_TEMPLATE_DEFINE("foreign formats: every k / 2^24, whether the store rounds or truncates", Format, lattice) {
    CAPTURE(Format::name);
    constexpr std::uint64_t one = 1 << 24;
    for (auto store : proof::stores) {
        const bool truncates = store == proof::unorm_store::truncates;
        CAPTURE(truncates);
        const auto below = proof::look_at<Format>(store, proof::nth_depth, 0, one);
        CHECK(below.failures == 0);
        CHECK(below.disorder == proof::faults_of<Format>.disorder_of_lattice[truncates]);
        const auto at_one = proof::look_at<Format>(store, proof::nth_depth, one, one + 1);
        CHECK(at_one.failures == 0);
        CHECK(at_one.disorder == (proof::faults_of<Format>.one < 1.0f));
        const double stated = Format{}.error(store).above;
        const bool is_sampled = Format::writes == umbrage::store_format::depth;  // which rounds once more, to a float
        if (stated >= 0x1p-23)  // finer ones show between the lattice only
            CHECK(below.error > 0.999 * stated - (is_sampled ? 0x1p-25 : 0.0));
    }
}
TEST_CASE_TEMPLATE_APPLY(lattice, proof::foreign);

TEST_CASE_TEMPLATE_DEFINE("foreign formats: NaN of either sign, infinities, negative values, denormals", Format, ends) {
    CAPTURE(Format::name);
    constexpr std::uint64_t nan = (1 << 23) - 1, zero = 1ull << 31, all = 1ull << 32;  // boundaries among all floats
    for (auto store : proof::stores)
        for (std::uint64_t at :
             {std::uint64_t(5000), nan, zero, zero + (1 << 23), zero + 0x3F800000u, zero + 0x7F800000u, all - 5000})
            CHECK(proof::look_at<Format>(store, proof::nth_float, at - 5000, at + 5000).failures == 0);
}
TEST_CASE_TEMPLATE_APPLY(ends, proof::foreign);
