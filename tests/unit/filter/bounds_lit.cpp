// SPDX-License-Identifier: MIT
#include <umbrage/filter/bounds_lit.hpp>

#include <doctest/doctest.h>

#include <limits>

#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/images/filter_bounds.hpp>

#include "maps.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("bounds_lit: by hand", T, float, double) {
    const auto bounds = [](glm::ivec2 at) { return glm::vec<2, T>(T(0.25), at.x < 1 ? T(0.5) : T(0.75)); };
    const glm::vec<2, T> place(0, T(1) / T(512));
    const auto lit = [&](T x, T receiver, auto... is_lit) {
        return bounds_lit(bounds, glm::vec<2, T>(x, 1), receiver, place, is_lit...);
    };
    CHECK(lit(1, T(0.25)) == 1);
    CHECK(lit(1, T(0.3)) == -1);
    CHECK(lit(T(1.99), T(0.6)) == 0);
    CHECK(lit(2, T(0.6)) == -1);
    CHECK(lit(1, T(0.6), greater_equal{}) == 1);
    CHECK(lit(1, T(0.2), greater_equal{}) == 0);
    CHECK(lit(1, T(1.5)) == 1);                               // beyond the far plane
    CHECK(lit(1, std::numeric_limits<T>::quiet_NaN()) == 0);  // in shadow everywhere
    CHECK(lit(std::numeric_limits<T>::infinity(), T(0.6)) == 1);
}

namespace {

/// Receivers of which bounds say anything, and those of which they do not say what the filter does.
struct answers {
    int known = 0, wrong = 0;
};

template <class Filter>
answers ask(const image<float>& map, Filter filter, depth_direction direction, outside_map outside) {
    filter.direction = direction;
    const float far = cleared_depth(direction);
    const auto made = make_filter_bounds(map.view(), filter.reach(), direction, serial{}, outside);
    const auto fetch = [&](glm::ivec2 texel) {
        return outside == outside_map::bordered ? fetch_bordered(map.view(), texel, far)
                                                : fetch_clamped(map.view(), texel);
    };
    std::mt19937 random(11);
    answers found;
    for (int i = 0; i < 3000; ++i) {
        glm::vec2 c;
        for (int axis : {0, 1})
            c[axis] = static_cast<float>(int(random() % unsigned(map.size()[axis] * 256 + 16384)) - 8192) / 256;
        const float depths[]{static_cast<float>(random() % 1025) / 1024.0f, fetch(glm::ivec2(glm::floor(c))), 0.5f,
                             0.5f};
        const float receiver = depths[i % 4];
        const float lit = bounds_lit(clamped(made.bounds), c, receiver, made.place, comparison{filter.direction});
        float asked = 0;
        if constexpr (requires { filter(fetch, c, receiver, glm::ivec2()); })
            asked = filter(fetch, c, receiver, glm::ivec2(i, i / 4));
        else asked = filter(fetch, c, receiver);
        found.known += lit >= 0.0f;
        found.wrong += lit >= 0.0f && lit != asked;
    }
    return found;
}

}  // namespace

TEST_CASE("bounds_lit: where bounds suffice every filter gives the same, NaN in the map or not") {
    std::mt19937 random(3);
    image<float> any = random_map(random, {70, 40}), shapes({120, 80});
    for (int i = 0; i < 300; ++i)
        any.texels()[random() % any.texels().size()] = std::numeric_limits<float>::quiet_NaN();
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 120; ++x) shapes[{x, y}] = (x / 40 + y / 40) % 2 ? 0.25f : 0.75f;
    filters::disc disc{.points = 32};
    disc.radius_texels = 5.3f;
    const auto check = [&](const auto& filter) {
        for (const auto direction : {depth_direction::forward, depth_direction::reversed})
            for (const auto outside : {outside_map::bordered, outside_map::clamped}) {
                const answers of_any = ask(any, filter, direction, outside),
                              of_shapes = ask(shapes, filter, direction, outside);
                CAPTURE(filter.reach());
                CHECK(of_any.wrong == 0);
                CHECK(of_shapes.wrong == 0);
                CHECK(of_shapes.known > 1000);
            }
    };
    for (const int radius : {0, 2, 8}) check(filters::box{radius});
    check(filters::tent<2>);
    check(filters::binomial<7>);
    check(disc);
}
