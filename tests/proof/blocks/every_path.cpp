// SPDX-License-Identifier: MIT
//
// visibility over images against the filters called for each receiver, bit by bit.
#include "one_by_one.hpp"

#include <initializer_list>
#include <string>
#include <type_traits>

#include "../../unit/rounds.hpp"

namespace {

using namespace paths;

/// Receivers of every kind in and around a map, in an image and in planes.
struct scattered {
    glm::ivec2 size{131, rounds(9)};
    image<glm::vec3> receivers{size};
    image<float> x_plane{size}, y_plane{size}, depth{size};
    glm::mat4 matrix{0.4f};

    /// @param tie  a depth that lies where the map's codes end
    scattered(glm::ivec2 map_size, values& v, const std::function<float(float)>& tie) {
        matrix[0][3] = 0.004f;
        matrix[1][3] = -0.03f;  // some receivers are behind the light
        matrix[3] = {-2.0f, 1.0f, 0.2f, 0.6f};
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec2 t(x, y);
                const float z = v.word() % 3 ? v.depth() : tie(v.unit());
                receivers[t].x = x_plane[t] = v.coord(map_size.x);
                receivers[t].y = y_plane[t] = v.coord(map_size.y);
                receivers[t].z = depth[t] = z;
            }
    }
    [[nodiscard]] umbrage::receiver_planes planes() const { return {x_plane, y_plane, depth}; }
    [[nodiscard]] umbrage::depth_receivers seen() const { return {depth, matrix, 0.01f}; }
};

template <class Encoding, class Filter>
void check_filter(Encoding encoding, Filter filter, glm::ivec2 map_size) {
    if constexpr (requires { encoding.direction = filter.direction; }) encoding.direction = filter.direction;
    const std::string name(filter.name);
    const float reach = filter.reach();  // which decides what meets the edge
    CAPTURE(name);
    CAPTURE(reach);
    CAPTURE(map_size.x);
    CAPTURE(map_size.y);
    values v;
    gapped<typename Encoding::texel> map(map_size);
    for (int y = 0; y < map_size.y; ++y)
        for (int x = 0; x < map_size.x; ++x) {
            const float d = v.depth();
            if constexpr (std::is_same_v<typename Encoding::texel, float>)
                map.view()[{x, y}] = d;  // a map of floats may hold anything
            else map.view()[{x, y}] = encoding.encode(d);
        }
    const scattered of(map_size, v, [&](float d) { return encoding.decode(encoding.encode(d)); });
    const any_filter alone(filter);
    const umbrage::image_view<const typename Encoding::texel> texels = map.view();
    const auto clamped_map = umbrage::decoded(umbrage::clamped(texels), encoding);
    const auto bordered_map = [&](glm::ivec2 texel) {
        const bool inside = texel.x >= 0 && texel.y >= 0 && texel.x < map_size.x && texel.y < map_size.y;
        return inside ? encoding.decode(texels[texel]) : alone.far;
    };
    const any_fetch fetch = erase(clamped_map), bordered = erase(bordered_map);
    const one_by_one clamped(alone, fetch, of.receivers);
    const auto against = [&](const one_by_one& wanted, const auto& receivers, bands parallel,
                             umbrage::outside_map outside = umbrage::outside_map::clamped) {
        check_each_path(wanted, [&](image<float>& out) {
            umbrage::visibility(map.view(), encoding, receivers, contrary(filter), out, parallel, outside);
        });
    };
    against(clamped, of.receivers, bands{7});
    against(one_by_one(alone, bordered, of.receivers), of.receivers, bands{3}, umbrage::outside_map::bordered);
    // Receivers know nothing of maps and filters, but that some of these ask for the pixel.
    if constexpr (std::is_same_v<Encoding, umbrage::depth32f> && (std::is_same_v<Filter, umbrage::filters::pcf_2x2> ||
                                                                  std::is_base_of_v<umbrage::filters::disc, Filter>)) {
        against(clamped, of.planes(), bands{2});
        against(one_by_one(alone, bordered, of.receivers), of.planes(), bands{2}, umbrage::outside_map::bordered);
        const auto seen_at = [&](glm::ivec2 pixel) { return umbrage::receiver_at(of.seen(), pixel); };
        // receiver_at is of tier C: wants -ffp-contract=off
        against(one_by_one(alone, fetch, of.size, seen_at), of.seen(), bands{1});
        against(one_by_one(alone, bordered, of.size, seen_at), of.seen(), bands{1}, umbrage::outside_map::bordered);
    }
}

/// The library's filters, each in each evaluation and with some radii, in either direction.
template <class Use>
void for_each_setting(std::initializer_list<int> radii, Use&& use) {
    umbrage::for_each_filter([&]<class Filter>(Filter filter) {
        const auto in_both_directions = [&] {
            forced::each_evaluation(filter, use);
            if constexpr (requires { filter.direction = umbrage::depth_direction::forward; }) {
                filter.direction = umbrage::depth_direction::reversed;
                forced::each_evaluation(filter, use);
                filter.direction = umbrage::depth_direction::forward;
            }
        };
        if constexpr (std::is_same_v<Filter, umbrage::filters::box>)
            for (int radius : radii) {
                filter.radius = radius;
                in_both_directions();
            }
        else in_both_directions();
    });
}

template <class Encoding>
void check_filters(Encoding encoding, std::initializer_list<int> radii) {
    for (const glm::ivec2 map_size :
         {glm::ivec2(1, 1), glm::ivec2(1, 9), glm::ivec2(2, 2), glm::ivec2(9, 4), glm::ivec2(67, 45)})
        for_each_setting(radii, [&]<class Filter>(const Filter& filter) {
            constexpr bool floats = std::is_same_v<Encoding, umbrage::depth32f>;  // as which these read any map
            constexpr bool needs_floats = std::is_base_of_v<umbrage::filters::window, Filter> ||
                                          std::is_base_of_v<umbrage::filters::disc, Filter>;
            if constexpr (floats || !needs_floats) check_filter(encoding, filter, map_size);
        });
}

}  // namespace

TEST_CASE("visibility: every path gives the filter's bits, float map") {
    check_filters(umbrage::depth32f{}, {-1, 0, 1, 2, 3, 4, 7, 8, 9});
}
// Filters with a radius read these maps as floats.
TEST_CASE("visibility: every path gives the filter's bits, 11-bit map") { check_filters(umbrage::rg<11>{}, {1}); }
TEST_CASE("visibility: every path gives the filter's bits, 16-bit map") {
    check_filters(umbrage::rg<16>{.edge = umbrage::center<float>}, {8});
}
TEST_CASE("visibility: every path gives the filter's bits, 24-bit map") { check_filters(umbrage::rgb24{}, {2}); }
TEST_CASE("visibility: every path gives the filter's bits, 9-bit map") { check_filters(umbrage::rg<9>{}, {3}); }
TEST_CASE("visibility: every path gives the filter's bits, a float's own bits") {
    check_filters(umbrage::float_bits{}, {5});
}

TEST_CASE("visibility: windows of one's own, of all sizes") {
    for (const int size : {1, 4, 8, 9, 15}) {
        umbrage::filters::window filter{umbrage::make_window_row(size, {1, 0.75f, 1, 0.5f, 1, 1.25f, 1, 1})};
        for (const glm::ivec2 map_size : {glm::ivec2(9, 4), glm::ivec2(67, 45)})
            check_filter(umbrage::depth32f{}, forced::every_texel{filter}, map_size);
    }
}

TEST_CASE("encode, visibility: large images, which bypass the cache, rows on and off multiples of 16 bytes") {
    const glm::ivec2 size(1057, 1001), map_size(67, 45);
    values v;
    gapped<float> depth(size), visibility(size);
    gapped<glm::u8vec4> texels(size);
    image<glm::u8vec2> map(map_size);
    image<glm::vec3> receivers(size);
    const umbrage::rg<11> rg;
    const umbrage::float_bits float_bits;
    for (auto& texel : map.texels()) texel = rg.encode(v.unit());
    for (auto& receiver : receivers.texels()) receiver = {v.coord(map_size.x), v.coord(map_size.y), v.unit()};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) depth.view()[{x, y}] = v.depth();
    REQUIRE(umbrage::detail::past_cache(visibility.view()));
    REQUIRE(umbrage::detail::past_cache(texels.view()));
    const auto fetch = umbrage::decoded(umbrage::clamped(std::as_const(map)), rg);
    const umbrage::filters::pcf_2x2 filter;
    image<float> wanted(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            wanted[{x, y}] = filter(fetch, glm::vec2(receivers[{x, y}]), receivers[{x, y}].z);
    for_each_path([&] {
        umbrage::encode(depth.view(), texels.view(), float_bits, bands{3});
        umbrage::visibility(map, rg, receivers, filter, visibility.view(), bands{3}, umbrage::outside_map::clamped);
        int different = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                different += texels.view()[{x, y}] != float_bits.encode(depth.view()[{x, y}]);
                different += visibility_bits(wanted[{x, y}]) != visibility_bits(visibility.view()[{x, y}]);
            }
        CHECK(different == 0);
        CHECK(texels.gaps_untouched());
        CHECK(visibility.gaps_untouched());
    });
}
