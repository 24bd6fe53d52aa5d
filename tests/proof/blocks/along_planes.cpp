// SPDX-License-Identifier: MIT
//
// visibility along receivers' planes over images against the filters called for each receiver, bit by bit.
#include "../../unit/fusing.hpp"
#include "../../unit/images/paths.hpp"
#include "../../unit/rounds.hpp"

#include <algorithm>
#include <string>

#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/plane_visibility.hpp>

namespace {

using namespace paths;

struct sloped {
    glm::ivec2 size;
    image<float> x{size}, y{size}, depth{size}, slope_x{size}, slope_y{size};
    [[nodiscard]] umbrage::sloped_receivers all() const { return {{x, y, depth}, slope_x, slope_y}; }
};

/// Receivers of anything, or in order over a map, most of them inside.
sloped receivers_for(glm::ivec2 map_size, bool in_order, values& v) {
    sloped s{in_order ? glm::ivec2(192, rounds(20)) : glm::ivec2(131, rounds(9))};
    for (glm::ivec2 p{0}; p.y < s.size.y; ++p.y)
        for (p.x = 0; p.x < s.size.x; ++p.x) {
            const bool anything = !in_order || v.word() % 200 == 0;
            s.x[p] = anything ? v.coord(map_size.x) : 9.0f + 1.03f * static_cast<float>(p.x);
            s.y[p] = anything ? v.coord(map_size.y) : 9.0f + 1.7f * static_cast<float>(p.y);
            s.depth[p] = anything ? v.depth() : 0.5f;
            s.slope_x[p] = anything && v.word() % 4 == 0 ? 4 * v.unit() - 2 : 0.02f * (v.unit() - 0.5f);
            s.slope_y[p] = anything && v.word() % 4 == 0 ? 4 * v.unit() - 2 : 0.02f * (v.unit() - 0.5f);
        }
    return s;
}

template <class Encoding, class Filter>
void check_map(Encoding encoding, const Filter& filter, glm::ivec2 map_size, bool in_order) {
    if constexpr (requires { encoding.direction = filter.direction; }) encoding.direction = filter.direction;
    CAPTURE(map_size.x);
    CAPTURE(in_order);
    values v;
    image<typename Encoding::texel> map(map_size);
    for (auto& texel : map.texels()) {
        const float d = in_order ? 0.45f + 0.1f * v.unit() : v.depth();
        texel = v.word() % 9 ? encoding.encode(d) : encoding.cleared();
    }
    const sloped of = receivers_for(map_size, in_order, v);
    const umbrage::image_view<const typename Encoding::texel> texels = map.view();
    const float cleared = umbrage::cleared_depth(filter.direction);
    for (const auto outside : {umbrage::outside_map::clamped, umbrage::outside_map::bordered}) {
        const auto fetch = [&](glm::ivec2 t) {
            const glm::ivec2 inside(std::clamp(t.x, 0, map_size.x - 1), std::clamp(t.y, 0, map_size.y - 1));
            return inside == t || outside == umbrage::outside_map::clamped ? encoding.decode(texels[inside]) : cleared;
        };
        const auto of_one = [&](glm::ivec2 p) {
            const glm::vec2 coord(of.x[p], of.y[p]), slope(of.slope_x[p], of.slope_y[p]);
            const auto moved =
                umbrage::apply_receiver_plane(fetch, slope, glm::vec3(coord, of.depth[p]), encoding.direction);
            if constexpr (requires { filter(moved, coord, 0.0f, p); }) return filter(moved, coord, of.depth[p], p);
            else return filter(moved, coord, of.depth[p]);
        };
        each_rounding(rounding_modes(), [&](int mode) {
            CAPTURE(mode);
            image<float> wanted(of.size);
            for (glm::ivec2 p{0}; p.y < of.size.y; ++p.y)
                for (p.x = 0; p.x < of.size.x; ++p.x) wanted[p] = of_one(p);
            const auto partly = std::ranges::count_if(wanted.texels(), [](float w) { return w > 0 && w < 1; });
            if (in_order && filter.reach() > 0.5f) CHECK(partly > rounds(100));
            for_each_isa([&] {
                image<float> out(of.size);
                umbrage::visibility(texels, encoding, of.all(), contrary(filter), out, bands{3}, outside);
                int differ = 0;
                for (glm::ivec2 p{0}; p.y < of.size.y; ++p.y)
                    for (p.x = 0; p.x < of.size.x; ++p.x)
                        differ += visibility_bits(wanted[p]) != visibility_bits(out[p]);
                CHECK(differ <= (may_fuse ? of.size.x * of.size.y / 20 : 0));  // fused, ties fall either way
            });
        });
    }
}

template <class Filter>
void check(Filter filter) {
    const std::string name(filter.name);
    CAPTURE(name);
    for (const auto direction : {umbrage::depth_direction::forward, umbrage::depth_direction::reversed}) {
        if constexpr (requires { filter.direction = direction; }) filter.direction = direction;
        else if (direction != umbrage::depth_direction::forward) continue;
        for (const glm::ivec2 map_size : {glm::ivec2(1, 1), glm::ivec2(2, 2), glm::ivec2(9, 4), glm::ivec2(67, 45)})
            check_map(umbrage::depth32f{}, filter, map_size, false);
        check_map(umbrage::depth32f{}, filter, {230, 61}, true);
        check_map(umbrage::rg<16>{}, filter, {230, 61}, true);
    }
}

}  // namespace

TEST_CASE("visibility along planes: every path gives the filter's bits") {
    umbrage::for_each_filter([](const auto& filter) { check(filter); });
    for (const int radius : {0, 2, 3, 4, 8}) check(umbrage::filters::box{.radius = radius});
    check(umbrage::filters::disc{16, 5.0f});
}

TEST_CASE("visibility along planes: every path gives contact hardening's bits") {
    umbrage::filters::soft::for_each([](auto filter) {
        filter.softness = {.per_code_x = 0.0625f, .per_code_y = 0.125f, .min_radius = 8, .max_radius = 80};
        check(filter);
    });
}
