// SPDX-License-Identifier: MIT
//
// acne_free_bias under every filter, each with a few of the planes and encodings. All of them: `make prove`.
#include <doctest/doctest.h>

#include "acne.hpp"

TEST_CASE("acne_free_bias: under every filter no receiver on a plane is dark, and 9/10 of it is too little") {
    std::uint64_t turn = 0, tight = 0;
    proof::for_each_percentage_closer([&](const auto& filter, umbrage::depth_direction direction) {
        std::uint64_t taken = 0;
        proof::for_each_decoder(direction, [&](const auto& encoding) {
            if (turn++ % 7 != 0) return;  // 36 decoders: another few for the next filter
            const std::uint64_t plane = (turn * 31 + taken++ * 5) % proof::planes;
            CAPTURE(filter.name);
            CAPTURE(filter.reach());
            CAPTURE(encoding.name);
            CAPTURE(plane);
            const proof::acne seen = proof::look_for_acne(filter, encoding, plane);
            CHECK(seen.dark == 0);
            CHECK(seen.loose == 0);
            tight += seen.tight;
        });
        CHECK(taken > 4);
    });
    CHECK(tight > 100);
}
