// SPDX-License-Identifier: MIT
//
// Filters by bounds against those that read every texel, which form.cpp holds against the filters themselves; and the
// choice between them.
#include "../../unit/images/paths.hpp"

#include <type_traits>
#include <utility>

#include <umbrage/images/visibility.hpp>

#include "../../forced_form.hpp"
#include "../../unit/rounds.hpp"

namespace {

using namespace paths;

/// Differing pixels, over every path and rounding mode.
template <class Filter>
int differing(const Filter& filter, const image<float>& map, const image<glm::vec3>& receivers,
              umbrage::outside_map outside) {
    int differ = 0;
    const umbrage::depth32f floats{filter.direction};
    for_each_path([&] {
        image<float> each(receivers.size()), at_once(receivers.size());
        umbrage::visibility(map, floats, receivers, forced::every_texel{filter}, each, bands{3}, outside);
        umbrage::visibility(map, floats, receivers, forced::by_bounds{filter}, at_once, bands{7}, outside);
        for (std::size_t i = 0; i < each.texels().size(); ++i)
            differ += visibility_bits(each.texels()[i]) != visibility_bits(at_once.texels()[i]);
    });
    return differ;
}

/// True when visibility() filters this number of receivers by bounds.
template <class Filter>
bool by_bounds(const Filter& filter, glm::ivec2 map_size, glm::ivec2 receivers) {
    static_assert(!std::is_void_v<typename umbrage::detail::block_form<Filter>::by_bounds>);
    return umbrage::detail::bounds_pay(umbrage::detail::width_of(filter), map_size,
                                       umbrage::detail::area_of(receivers));
}

}  // namespace

TEST_CASE(
    "hierarchical filters: the bits of those that ask for each texel, maps of anything and shadows with more inside "
    "than border") {
    values v;
    // The last one's rows share their places in a cache, so that boxes are read in a copy.
    for (const glm::ivec2 map_size :
         {glm::ivec2(1, 1), glm::ivec2(63, 9), glm::ivec2(67, 45), glm::ivec2(200, 130), glm::ivec2(512, 90)}) {
        image<float> any(map_size), shapes(map_size);
        for (float& texel : any.texels()) texel = v.depth();
        for (int y = 0; y < map_size.y; ++y)
            for (int x = 0; x < map_size.x; ++x)
                shapes[{x, y}] = (x / 40 + y / 30) % 2 ? 0.25f : 0.75f + 0.01f * v.unit();
        image<glm::vec3> scattered({131, rounds(9)}), walk({192, rounds(60)});
        for (glm::vec3& r : scattered.texels()) r = {v.coord(map_size.x), v.coord(map_size.y), v.depth()};
        for (int y = 0; y < walk.size().y; ++y)
            for (int x = 0; x < walk.size().x; ++x)
                walk[{x, y}] = {static_cast<float>(x) * 1.03f - 4.0f, static_cast<float>(y) * 2.1f - 3.0f,
                                y % 7 ? 0.5f : 0.755f};
        const auto check = [&](const auto& filter) {
            CAPTURE(map_size.x);
            CAPTURE(filter.reach());
            CHECK(differing(filter, any, scattered, umbrage::outside_map::clamped) == 0);
            CHECK(differing(filter, shapes, walk, umbrage::outside_map::clamped) == 0);
            CHECK(differing(filter, shapes, walk, umbrage::outside_map::bordered) == 0);
        };
        for (const auto direction : {umbrage::depth_direction::forward, umbrage::depth_direction::reversed}) {
            for (umbrage::filters::window filter :
                 {umbrage::filters::tent<2>, umbrage::filters::binomial<7>, umbrage::filters::castano<7>,
                  umbrage::filters::window{umbrage::make_window_row(15, {1, 1, 1, 1, 1, 1, 1, 1})}}) {
                filter.direction = direction;
                check(filter);
            }
            for (const float radius : {2.0f, 16.0f}) {
                umbrage::filters::disc disc{.points = 8};
                disc.radius_texels = radius;
                disc.direction = direction;
                check(disc);
            }
            for (const int radius : {0, 3, 4, 8}) check(umbrage::filters::box{radius, direction});
        }
    }
}

TEST_CASE("box, window and disc: by bounds where these pay") {
    using umbrage::filters::box;
    const glm::ivec2 map(256, 256);
    for (const int radius : {-1, 0, 1, 2}) CHECK_FALSE(by_bounds(box{radius}, map, map));
    for (const int radius : {3, 4, 8, 9}) CHECK(by_bounds(box{radius}, map, map));
    CHECK_FALSE(by_bounds(umbrage::filters::tent<3>, map, map));
    CHECK(by_bounds(umbrage::filters::castano<5>, map, map));
    CHECK(by_bounds(umbrage::filters::castano<7>, map, map));
    umbrage::filters::disc disc{.points = 16};
    for (const auto& [radius, pays] : {std::pair(2.0f, false), std::pair(8.0f, true), std::pair(16.0f, false)}) {
        disc.radius_texels = radius;
        CAPTURE(disc.radius_texels);
        CHECK(by_bounds(disc, map, map) == pays);
    }
    // The bounds are a pass over the map: it is too much work for few receivers.
    CHECK(by_bounds(box{8}, map, {256, 16}));
    CHECK_FALSE(by_bounds(box{8}, map, {256, 15}));
    CHECK(by_bounds(box{3}, map, {256, 103}));
    CHECK_FALSE(by_bounds(box{3}, map, {256, 102}));
    CHECK_FALSE(by_bounds(box{8}, {63, 256}, {256, 256}));
}
