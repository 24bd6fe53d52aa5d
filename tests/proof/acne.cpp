// SPDX-License-Identifier: MIT
//
// acne_free_bias under every filter, each with a few of the planes and encodings; discs of one radius, in every turn
// with one encoding. All of them: `make prove`.
#include <doctest/doctest.h>

#include "acne.hpp"

namespace {

bool owes(const proof::any_filter& filter, const proof::any_encoding& encoding, float bias, proof::moved_plane& moved) {
    CAPTURE(filter.name);
    CAPTURE(filter.reach);
    CAPTURE(encoding.name);
    CAPTURE(moved.slope.x);
    CAPTURE(moved.slope.y);
    const proof::acne seen = proof::look_for_acne(filter, encoding, bias, moved);
    CHECK(seen.dark == 0);
    CHECK_FALSE(seen.loose);
    return seen.owed;
}

}  // namespace

TEST_CASE("acne_free_bias: under every filter no receiver on a plane is dark, and 9/10 of it is too little") {
    std::uint64_t turn = 0, owed = 0;
    proof::for_each_percentage_closer([&]<class Filter>(const Filter& filter, umbrage::depth_direction direction) {
        if constexpr (std::is_same_v<Filter, umbrage::filters::disc>)
            if (filter.radius_texels != 2.0f) return;
        proof::any_filter erased(filter, direction);
        const bool turned = erased.turned;
        std::uint64_t taken = 0;
        proof::for_each_decoder(direction, [&](const auto& encoding) {
            if (turn++ % 7 != 0) return;  // 36 decoders: another few for the next filter
            erased.turned = turned && taken == 0;
            proof::moved_plane moved((turn * 31 + taken++ * 5) % proof::plane_count, erased.reach);
            const float bias = umbrage::acne_free_bias(moved.slope, filter, encoding);
            owed += owes(erased, proof::any_encoding(encoding), bias, moved);
        });
        CHECK(taken > 4);
    });
    CHECK(owed > 100);
}
