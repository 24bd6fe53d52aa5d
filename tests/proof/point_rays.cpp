// SPDX-License-Identifier: MIT
//
// Every kind of map around a point light in every convention, over some random scenes.
#include "point_rays.hpp"

#include <doctest/doctest.h>

namespace {

template <class Maps>
void agrees() {
    proof::verdicts all;
    for (std::uint64_t n = 0; n < 2 * proof::clip_space_count; ++n) {
        proof::verdicts found = proof::compare_with_rays<Maps>(n, umbrage::filters::hard{}, 400);
        found += proof::compare_with_rays<Maps>(n, umbrage::filters::pcf_2x2{}, 400);
        CAPTURE(Maps::name);
        CAPTURE(n);
        CHECK(found.wrong == 0);
        all += found;
    }
    CHECK(all.lit > 3000);
    CHECK(all.shadowed > 800);
}

}  // namespace

TEST_CASE("a point light's maps, drawn and looked up, agree with rays, away from edges and beyond the margin") {
    agrees<proof::paraboloid_maps>();
    agrees<proof::tetrahedron_map>();
}
