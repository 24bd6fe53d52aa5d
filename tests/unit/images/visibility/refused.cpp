// SPDX-License-Identifier: MIT
//
// Filters whose numbers their members exclude: refused before a texel is read or written.
#include <doctest/doctest.h>

#include <stdexcept>

#include <umbrage/filter/filters.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/visibility.hpp>

using namespace umbrage;

namespace {

/// Refused as points, as planes of points, and along their planes. Then nothing is written.
bool refused(const auto& filter) {
    const image<float> map({40, 40}, 0.3f), x({130, 3}, 19.7f), slope({130, 3});
    const image<glm::vec3> points({130, 3}, {19.7f, 20.2f, 0.5f});
    image<float> out({130, 3}, -1.0f);
    int count = 0;
    const auto run = [&](const auto& receivers) {
        try {
            visibility(map, depth32f{}, receivers, filter, out);
        } catch (const std::invalid_argument&) { ++count; }
    };
    run(points.view());
    run(receiver_planes{x, x, x});
    run(sloped_receivers{{x, x, x}, slope, slope});
    for (const float v : out.texels())
        if (v != -1.0f) return false;
    return count == 3;
}

}  // namespace

TEST_CASE_TEMPLATE("visibility: discs of other than 8, 16 or 32 points are refused", Filter, filters::disc,
                   filters::pcss, filters::dpcf) {
    for (const int points : {0, 4, 12, 64, 1 << 30}) CHECK(refused(Filter{.points = points}));
    CHECK_FALSE(refused(Filter{.points = 8}));
}

TEST_CASE("visibility: a window of 16 weights is refused") {
    filters::window filter;
    CHECK_FALSE(refused(filter));
    filter.row.size = 16;
    CHECK(refused(filter));
}

TEST_CASE_TEMPLATE("visibility: a softness that make_penumbra_params never makes is refused", Filter, filters::pcss,
                   filters::dpcf) {
    for (const penumbra_params& bad :
         {penumbra_params{-1, 0.06f, 16, 96}, {0.06f, -1, 16, 96}, {0.06f, 0.06f, 96, 16}, {0.06f, 0.06f, 1.5f, 7.25f}})
        CHECK(refused(Filter{.softness = bad}));
    CHECK_FALSE(refused(Filter{.softness = {0.06f, 0.04f, 0, 4095}}));
}
