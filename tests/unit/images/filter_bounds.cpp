// SPDX-License-Identifier: MIT
#include <umbrage/images/filter_bounds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <glm/common.hpp>

#include "../filter/maps.hpp"

using namespace umbrage;

namespace {

/// Bounds of the texels whose centers lie within `reach` of c, and of `more` texels beyond on each side.
glm::dvec2 by_hand(const image<float>& map, glm::vec2 c, double reach, int more) {
    glm::dvec2 bounds(2, -2);
    const auto first = [&](float at) { return static_cast<int>(std::ceil(double(at) - reach - 0.5)) - more; };
    const auto last = [&](float at) { return static_cast<int>(std::floor(double(at) + reach - 0.5)) + more; };
    for (int y = first(c.y); y <= last(c.y); ++y)
        for (int x = first(c.x); x <= last(c.x); ++x) {
            const double depth = texel_at(map, x, y);
            bounds = {std::min(bounds.x, depth), std::max(bounds.y, depth)};
        }
    return bounds;
}

}  // namespace

TEST_CASE("filter_bounds: hold every texel within reach, and none farther off than two squares") {
    std::mt19937 random(5);
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(7, 5), glm::ivec2(90, 33)})
        for (const float reach : {0.5f, 2.0f, 4.0f, 8.5f, 14.6337f}) {
            image<float> map = random_map(random, size, 1024);
            const auto [bounds, place] =
                make_filter_bounds(map.view(), reach, depth_direction::forward, serial{}, outside_map::clamped);
            const int squares = static_cast<int>(1.0f / (place.y * 256.0f));
            int outside = 0, loose = 0;
            for (int i = 0; i < 200; ++i) {
                glm::vec2 c;
                for (int axis : {0, 1})
                    c[axis] = static_cast<float>(int(random() % unsigned(size[axis] * 256 + 8192)) - 4096) / 256;
                const glm::ivec2 at(glm::floor((c * 256.0f + place.x) * place.y));
                const glm::dvec2 found(fetch_clamped(bounds.view(), at)),
                    inner = by_hand(map, c, reach, 0),
                    outer = by_hand(map, glm::clamp(c, glm::vec2(), glm::vec2(size)), reach, 2 * squares + 1);
                outside += found.x > inner.x || found.y < inner.y;
                loose += found.x < outer.x || found.y > outer.y;
            }
            CAPTURE(size.x);
            CAPTURE(reach);
            CHECK(outside == 0);
            CHECK(loose == 0);
        }
}

TEST_CASE("filter_bounds: NaN, borders, and what is refused") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    image<float> map({16, 16}, 0.5f);
    map[{15, 15}] = nan;
    const filter_bounds some =
        make_filter_bounds(map.view(), 1.0f, depth_direction::forward, serial{}, outside_map::clamped);
    CHECK(some.bounds.view().row(0)[0] == glm::vec2(0.5f));
    const glm::ivec2 last = some.bounds.size() - 1;
    CHECK(std::isnan(some.bounds.view().row(last.y)[last.x].x));
    CHECK(some.bounds.view().row(last.y)[last.x].y == 0.5f);
    CHECK(make_filter_bounds(map.view(), 1.0f).bounds.view().row(0)[0].y == 1.0f);
    CHECK(make_filter_bounds(map.view(), 1.0f, depth_direction::reversed).bounds.view().row(0)[0].x == 0.0f);
    CHECK_THROWS_AS((void)make_filter_bounds(image_view<const float>{}, 1.0f), std::invalid_argument);
    CHECK_THROWS_AS((void)make_filter_bounds(map.view(), -1.0f), std::invalid_argument);
    CHECK_THROWS_AS((void)make_filter_bounds(map.view(), nan), std::invalid_argument);
}
