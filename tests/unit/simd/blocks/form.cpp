// SPDX-License-Identifier: MIT
//
// visibility over images against the filters called for each receiver, bit by bit.
#include "paths.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <type_traits>

#include <umbrage/images/visibility.hpp>

namespace {

using namespace paths;

/// Any map's texel as its depth: filters are compiled for no other fetch, here as in visibility().
using any_fetch = umbrage::detail::erased_fetch;
using umbrage::detail::erase;

using any_receivers = std::function<glm::vec3(glm::ivec2)>;

/// A filter, whichever: what is held against it is compiled once for all of them.
struct any_filter {
    std::function<float(const any_fetch&, glm::vec3, glm::ivec2)> at;
    float far = 1.0f;

    template <class Filter>
    explicit any_filter(const Filter& filter)
        : at([=](const any_fetch& fetch, glm::vec3 receiver, glm::ivec2 pixel) {
              if constexpr (requires { filter(fetch, glm::vec2(), 0.0f, pixel); })
                  return filter(fetch, glm::vec2(receiver), receiver.z, pixel);
              else return filter(fetch, glm::vec2(receiver), receiver.z);
          }) {
        if constexpr (requires { filter.is_lit.direction; }) far = umbrage::cleared_depth(filter.is_lit.direction);
    }
};

/// What the filter gives for each receiver alone, in some rounding modes.
class one_by_one {
public:
    one_by_one(const any_filter& filter, const any_fetch& fetch, glm::ivec2 size, const any_receivers& at) {
        each_rounding(modes_, [&](int mode) {
            image<float>& out = wanted_.emplace(mode, size).first->second;
            for (int y = 0; y < out.size().y; ++y)
                for (int x = 0; x < out.size().x; ++x) out[{x, y}] = filter.at(fetch, at({x, y}), {x, y});
        });
    }
    [[nodiscard]] const std::vector<int>& modes() const { return modes_; }
    [[nodiscard]] glm::ivec2 size() const { return wanted_.begin()->second.size(); }
    one_by_one(const any_filter& filter, const any_fetch& fetch, const image<glm::vec3>& receivers)
        : one_by_one(filter, fetch, receivers.size(), [&](glm::ivec2 pixel) { return receivers[pixel]; }) {}
    /// Pixels that have other bits, in the rounding mode of now.
    int differing(const image<float>& from) const {
        const image<float>& wanted = wanted_.at(std::fegetround());
        int differ = 0;
        for (std::size_t i = 0; i < from.texels().size(); ++i)
            differ += visibility_bits(wanted.texels()[i]) != visibility_bits(from.texels()[i]);
        return differ;
    }

private:
    std::vector<int> modes_ = rounding_modes();
    std::map<int, image<float>> wanted_;
};

using render = std::function<void(image<float>&)>;

/// That each path gives what the filter gives for each receiver alone.
void check_each_path(const one_by_one& wanted, const render& to) {
    for_each_path(wanted.modes(), [&] {
        image<float> out(wanted.size());
        to(out);
        CHECK(wanted.differing(out) == 0);
    });
}

/// Receivers of every kind in and around a map, in an image and in planes.
struct scattered {
    glm::ivec2 size{131, 9};
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
    const auto clamped_map = umbrage::decoded(texels, encoding);
    const auto bordered_map = [&](glm::ivec2 texel) {
        const bool inside = texel.x >= 0 && texel.y >= 0 && texel.x < map_size.x && texel.y < map_size.y;
        return inside ? encoding.decode(texels[texel]) : alone.far;
    };
    const any_fetch fetch = erase(clamped_map), bordered = erase(bordered_map);
    const one_by_one clamped(alone, fetch, of.receivers);
    const auto against = [&](const one_by_one& wanted, const auto& receivers, bands parallel,
                             umbrage::outside_map outside = umbrage::outside_map::clamped) {
        check_each_path(wanted, [&](image<float>& out) {
            umbrage::visibility(map.view(), encoding, receivers, filter, out, parallel, outside);
        });
    };
    against(clamped, of.receivers, bands{7});
    against(one_by_one(alone, bordered, of.receivers), of.receivers, bands{3}, umbrage::outside_map::lit);
    // Receivers know nothing of maps and filters, but that some of these ask for the pixel.
    if constexpr (std::is_same_v<Encoding, umbrage::depth32f> &&
                  (std::is_same_v<Filter, umbrage::filters::pcf_2x2> ||
                   std::is_same_v<Filter, umbrage::filters::rotated_disc>)) {
        against(clamped, of.planes(), bands{2});
        const auto seen_at = [&](glm::ivec2 pixel) { return umbrage::receiver_at(of.seen(), pixel); };
        // receiver_at is of tier C: wants -ffp-contract=off
        against(one_by_one(alone, fetch, of.size, seen_at), of.seen(), bands{1});
    }
}

image<glm::vec3> in_a_row(glm::ivec2 size, glm::ivec2 map_size, glm::vec2 start, glm::vec2 step) {
    image<glm::vec3> receivers(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            receivers[{x, y}] = glm::vec3(start + step * glm::vec2(x, y), 0.3f + 0.02f * static_cast<float>(y));
    receivers[{5, 3}].z = std::numeric_limits<float>::quiet_NaN();
    receivers[{70, 4}].x = -3.0f;
    receivers[{130, 5}].x = static_cast<float>(map_size.x) - 0.5f;
    return receivers;
}

/// Receivers that follow each other through a map, most of them well inside: whole blocks that need no care.
/// Rows of 512 and 1024 floats push each other out of the cache, and large boxes then go through a copy.
template <class Encoding, class Filter>
void check_coherent(Encoding encoding, Filter filter, glm::ivec2 map_size, glm::vec2 start = {12.0f, 9.0f},
                    glm::vec2 step = {1.03f, 1.7f}) {
    CAPTURE(map_size.x);
    CAPTURE(start.x);
    values v;
    image<typename Encoding::texel> map(map_size);
    for (auto& texel : map.texels()) texel = encoding.encode(0.3f + 0.4f * v.unit());
    const image<glm::vec3> receivers = in_a_row({192, 24}, map_size, start, step);
    const auto fetch = umbrage::decoded(std::as_const(map).view(), encoding);
    check_each_path(one_by_one(any_filter(filter), erase(fetch), receivers),
                    [&](image<float>& out) { umbrage::visibility(map, encoding, receivers, filter, out, bands{3}); });
}

/// The library's filters, each with some radii, in either direction.
template <class Use>
void for_each_setting(std::initializer_list<int> radii, Use&& use) {
    umbrage::for_each_filter([&](auto filter) {
        const auto in_both_directions = [&] {
            use(filter);
            if constexpr (requires { filter.is_lit.direction; }) {
                filter.is_lit.direction = umbrage::depth_direction::reversed;
                use(filter);
                filter.is_lit.direction = umbrage::depth_direction::forward;
            }
        };
        if constexpr (requires { filter.radius; })
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
            constexpr bool needs_floats = std::is_same_v<Filter, umbrage::filters::window> ||
                                          std::is_same_v<Filter, umbrage::filters::rotated_disc>;
            if constexpr (floats || !needs_floats) check_filter(encoding, filter, map_size);
        });
}

}  // namespace

TEST_CASE("visibility: every path gives the filter's bits, float map") {
    check_filters(umbrage::depth32f{}, {-1, 0, 1, 2, 3, 4, 7, 8, 9});
}
// What has a radius reads these maps as floats.
TEST_CASE("visibility: every path gives the filter's bits, 11-bit map") { check_filters(umbrage::rg<11>{}, {1}); }
TEST_CASE("visibility: every path gives the filter's bits, 16-bit map") {
    check_filters(umbrage::rg<16>{.edge = umbrage::centre<float>}, {8});
}
TEST_CASE("visibility: every path gives the filter's bits, 24-bit map") { check_filters(umbrage::rgb24{}, {2}); }

TEST_CASE("visibility: whole blocks inside the map, and rows that collide in the cache") {
    for (const glm::ivec2 map_size : {glm::ivec2(512, 61), glm::ivec2(600, 61), glm::ivec2(1024, 61)}) {
        check_coherent(umbrage::depth32f{}, umbrage::filters::pcf_2x2{}, map_size);
        check_coherent(umbrage::rg<11>{}, umbrage::filters::pcf_2x2{}, map_size);
        for (int radius : {0, 1, 2, 3, 4, 6, 8}) {
            check_coherent(umbrage::depth32f{}, umbrage::filters::box{radius}, map_size);
            check_coherent(umbrage::depth32f{}, umbrage::filters::hierarchical_box{radius}, map_size);
            check_coherent(umbrage::rg<16>{}, umbrage::filters::box{radius}, map_size);
            // From the far corner of the map on: as near to it as eight lanes can be loaded for every row, and one
            // texel on.
            for (const float beyond : {7.5f, 6.5f}) {
                const auto corner = glm::vec2(map_size - radius) - glm::vec2(beyond, 0.5f);
                check_coherent(umbrage::depth32f{}, umbrage::filters::box{radius}, map_size, corner, {-1.03f, -1.7f});
            }
        }
    }
}

TEST_CASE("visibility: windows of one's own, of all sizes, discs of all radii, and whole blocks inside the map") {
    for (const int size : {1, 4, 8, 9, 15}) {
        umbrage::filters::window filter{umbrage::make_window_row(size, {1, 0.75f, 1, 0.5f, 1, 1.25f, 1, 1})};
        for (const glm::ivec2 map_size : {glm::ivec2(9, 4), glm::ivec2(67, 45)})
            check_filter(umbrage::depth32f{}, filter, map_size);
    }
    for (const umbrage::filters::window& filter : umbrage::filters::window::values)
        check_coherent(umbrage::depth32f{}, filter, {600, 61});
    for (umbrage::filters::rotated_disc filter : umbrage::filters::rotated_disc::values)
        for (const float radius : {0.0f, 0.4f, 3.2f, 5.3f, 300.0f}) {
            filter.radius_texels = radius;
            check_coherent(umbrage::depth32f{}, filter, {600, 61});
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
    const auto fetch = umbrage::decoded(std::as_const(map).view(), rg);
    const umbrage::filters::pcf_2x2 filter;
    image<float> wanted(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            wanted[{x, y}] = filter(fetch, glm::vec2(receivers[{x, y}]), receivers[{x, y}].z);
    for_each_path([&] {
        umbrage::encode(depth.view(), texels.view(), float_bits, bands{3});
        umbrage::visibility(map, rg, receivers, filter, visibility.view(), bands{3});
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

TEST_CASE("visibility: maps that reach beyond texel space, up to its last texels") {
    for (const glm::ivec2 map_size : {glm::ivec2(32769, 2), glm::ivec2(2, 32770)}) {
        const bool wide = map_size.x > map_size.y;
        const glm::vec2 along = wide ? glm::vec2(1, 0) : glm::vec2(0, 1), start = 32762.0f * along + glm::vec2(0.4f);
        umbrage::for_each_filter([&](const auto& filter) {
            check_coherent(umbrage::depth32f{}, filter, map_size, start, 0.03125f * along);
        });
        check_coherent(umbrage::rg<11>{}, umbrage::filters::pcf_2x2{}, map_size, start, 0.03125f * along);
    }
}
