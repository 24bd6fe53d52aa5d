// SPDX-License-Identifier: MIT
//
// Every kind of light, every fit and every convention over some random scenes.
#include "page_rays.hpp"

#include <doctest/doctest.h>

#include <array>

TEST_CASE("a light fitted, drawn and looked up agrees with rays, away from edges and beyond the bias") {
    std::array<proof::verdicts, proof::light_kinds.size()> kinds;
    for (std::uint64_t n = 0; n < 3 * proof::setting_count; ++n) {
        proof::ray_scene scene(n);
        proof::verdicts found;
        found += scene.compare(umbrage::filters::hard{}, 180);
        found += scene.compare(umbrage::filters::pcf_2x2{}, 180);
        kinds[n % kinds.size()] += found;
        CAPTURE(n);
        CAPTURE(scene.kind());
        CHECK(found.wrong == 0);
        CHECK(found.by_shadow == 0);
        CHECK(found.outside == 0);
    }
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        CAPTURE(proof::light_kinds[kind].name);
        CHECK(kinds[kind].lit > 200);
        CHECK(kinds[kind].shadowed > 150);
    }
}

TEST_CASE("pages drawn within a budget and found by their table agree with rays, at every level") {
    std::array<int, 16> levels{};
    proof::verdicts all;
    for (std::uint64_t n = 0; n < 2 * proof::clip_space_count; ++n) {
        proof::page_scene scene(n);
        proof::verdicts found;
        found += scene.compare(umbrage::filters::hard{}, 300, levels);
        found += scene.compare(umbrage::filters::pcf_2x2{}, 300, levels);
        CAPTURE(n);
        CHECK(found.wrong == 0);
        CHECK(found.outside == 0);
        all += found;
    }
    CHECK(all.lit > 1000);
    CHECK(all.shadowed > 1000);
    for (const int level : {3, 4, 5, 6}) CHECK(levels[std::size_t(level)] > 100);
}
