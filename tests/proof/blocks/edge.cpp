// SPDX-License-Identifier: MIT
//
// visibility over images in a band around the map's edges: by default each filter gives what it gives for each
// receiver of bordered(map) alone, bit by bit.
#include "one_by_one.hpp"

#include <algorithm>
#include <string>

#include <umbrage/images/blocks/soft.hpp>

#include "../../unit/rounds.hpp"

namespace {

using namespace paths;

/// Receivers up to so many texels off one of the map's four edges or corners, in whole blocks and in some that only
/// touch the band.
image<glm::vec3> around_edges(glm::ivec2 map_size, float band, values& v) {
    image<glm::vec3> receivers({200, rounds(24)});
    for (int y = 0; y < receivers.size().y; ++y)
        for (int x = 0; x < 200; ++x) {
            const glm::vec2 size(map_size), along(v.unit(), v.unit()), off((v.unit() - 0.5f) * 2 * band);
            glm::vec2 c = along * size;
            if (y % 3 == 0) c.x = (x & 1 ? size.x : 0.0f) + off.x;
            if (y % 3 == 1) c.y = (x & 1 ? size.y : 0.0f) + off.y;
            if (y % 8 == 2 && x % 7) c = size * 0.5f;  // blocks in which few receivers are at an edge
            receivers[{x, y}] = {c.x, c.y, x % 5 ? v.unit() : 0.625f};
        }
    receivers[{7, 0}].z = std::numeric_limits<float>::quiet_NaN();
    receivers[{9, 0}].z = 1.5f;
    return receivers;
}

/// Both kinds of outside, and that they differ: the band meets the edge.
template <class Encoding, class Filter>
void check_edge(Encoding encoding, const Filter& filter, glm::ivec2 map_size) {
    if constexpr (requires { encoding.direction = filter.direction; }) encoding.direction = filter.direction;
    const std::string name(filter.name);
    CAPTURE(name);
    CAPTURE(map_size.x);
    values v;
    image<typename Encoding::texel> map(map_size);
    for (auto& texel : map.texels()) texel = encoding.encode(0.4f + 0.4f * v.unit());
    const image<glm::vec3> receivers = around_edges(map_size, filter.reach() + 2.0f, v);
    const auto fetch = umbrage::decoded(map, encoding);
    const auto clamped_fetch = umbrage::clamped(fetch);
    const one_by_one bordered(any_filter(filter), erase(fetch), receivers),
        clamped(any_filter(filter), erase(clamped_fetch), receivers);
    const auto given = contrary(filter);
    check_each_path(bordered,
                    [&](image<float>& out) { umbrage::visibility(map, encoding, receivers, given, out, bands{3}); });
    image<float> at_edge(receivers.size());
    umbrage::visibility(map, encoding, receivers, given, at_edge, bands{2}, umbrage::outside_map::clamped);
    CHECK(clamped.differing(at_edge) == 0);
    CHECK(bordered.differing(at_edge) > rounds(100));
}

template <class Filter>
void check_in_both_directions(Filter filter) {
    for (const auto direction : {umbrage::depth_direction::forward, umbrage::depth_direction::reversed}) {
        if constexpr (requires { filter.direction = umbrage::depth_direction::forward; }) filter.direction = direction;
        for (const glm::ivec2 map_size : {glm::ivec2(70, 50), glm::ivec2(5, 9)})
            check_edge(umbrage::depth32f{}, filter, map_size);
        check_edge(umbrage::rg<11>{}, filter, {70, 50});
    }
}

}  // namespace

TEST_CASE("visibility: in a band around the edges each filter sees the far plane outside") {
    umbrage::for_each_filter([](const auto& filter) { check_in_both_directions(filter); });
    for (const int radius : {1, 4, 8}) check_in_both_directions(forced::every_texel{umbrage::filters::box{radius}});
}

TEST_CASE("visibility: in a band around the edges filters by bounds see the far plane outside") {
    check_in_both_directions(forced::by_bounds{umbrage::filters::box{5}});
    check_in_both_directions(forced::by_bounds{umbrage::filters::castano<7>});
    umbrage::filters::disc disc{.points = 32};
    disc.radius_texels = 6.5f;
    check_in_both_directions(forced::by_bounds{disc});
}

TEST_CASE("visibility: in a band around the edges contact hardening sees the far plane outside") {
    umbrage::filters::soft::for_each([](auto filter) {
        filter.softness = {.per_code_x = 1.0f / 1024, .per_code_y = 1.0f / 1024, .min_radius = 16, .max_radius = 128};
        check_in_both_directions(filter);
    });
}

TEST_CASE("visibility: a floor that goes on beyond the map is lit there by default") {
    const image<float> map({64, 64}, 0.5f);  // a caster over all of it
    image<glm::vec3> receivers({200, 200});
    int beyond = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) receivers[{x, y}] = {float(x) - 67.5f, float(y) - 67.5f, 0.75f};
    image<float> out({200, 200}), packed_out({200, 200});
    image<glm::u8vec2> packed({64, 64}, umbrage::rg<11>{}.encode(0.5f));
    umbrage::for_each_filter([&](const auto& filter) {
        umbrage::visibility(map, umbrage::depth32f{}, receivers, filter, out);
        umbrage::visibility(packed, umbrage::rg<11>{}, receivers, filter, packed_out);
        const float reach = filter.reach() + 0.5f;
        int dark = 0, lit = 0;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 200; ++x) {
                const glm::vec2 c(receivers[{x, y}]), out_by = glm::abs(c - 32.0f) - 32.0f;
                const float apart = std::max(out_by.x, out_by.y), a = out[{x, y}], b = packed_out[{x, y}];
                if (apart > reach) beyond += 1, dark += a != 1.0f || b != 1.0f;
                if (apart < -reach) lit += a != 0.0f || b != 0.0f;
            }
        CAPTURE(filter.name);
        CHECK(dark == 0);
        CHECK(lit == 0);
    });
    CHECK(beyond > 100000);
}
