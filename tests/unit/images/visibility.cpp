// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <umbrage/depth/conversions.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/images/visibility.hpp>

#include "../rounds.hpp"

using namespace umbrage;

namespace {

/// Receivers in and around a map of this size; every coordinate that a filter treats in a way of its own is among them.
image<glm::vec3> receivers_for(glm::ivec2 of_map, glm::ivec2 size, std::mt19937& random) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    std::uniform_real_distribution<float> anywhere(-0.2f, 1.2f), depth(0, 1);
    std::uniform_int_distribution<int> one_in(0, 9), texel(-9, of_map.x + 9), eighth(0, 8);
    const std::array special{nan,
                             -nan,
                             infinity,
                             -infinity,
                             32768.0f,
                             -32768.0f,
                             std::nextafter(32768.0f, 0.0f),
                             std::nextafter(-32768.0f, 0.0f),
                             65536.0f,
                             1e30f,
                             -1e-30f,
                             -0.0f,
                             0.0f,
                             40000.0f,
                             -1e9f};
    std::uniform_int_distribution<std::size_t> pick(0, special.size() - 1);
    image<glm::vec3> out(size);
    for (glm::vec3& r : out.texels()) {
        r = {anywhere(random) * static_cast<float>(of_map.x), anywhere(random) * static_cast<float>(of_map.y),
             depth(random)};
        if (one_in(random) == 0) r.x = static_cast<float>(texel(random)) + static_cast<float>(eighth(random)) / 8;
        if (one_in(random) == 0) r.y = static_cast<float>(texel(random));
        if (one_in(random) == 0) r[one_in(random) % 3] = special[pick(random)];
        if (one_in(random) < 4) r.z = static_cast<float>(eighth(random)) / 8;
    }
    return out;
}

template <class Encoding>
image<typename Encoding::texel> packed_map(Encoding encoding, glm::ivec2 size, std::mt19937& random) {
    std::uniform_int_distribution<int> eighth(0, 8);
    std::uniform_real_distribution<float> depth(0, 1);
    image<typename Encoding::texel> map(size);
    for (auto& texel : map.texels())
        texel = encoding.encode(eighth(random) % 2 ? static_cast<float>(eighth(random)) / 8 : depth(random));
    return map;
}

/// Number of pixels whose bits are not the primitive's. The primitive is called by hand, with a fetch of our own.
template <class Encoding, class Filter, class Primitive>
int differing(Encoding encoding, glm::ivec2 of_map, glm::ivec2 size, Filter filter, Primitive primitive,
              unsigned seed) {
    std::mt19937 random(seed);
    const auto map = packed_map(encoding, of_map, random);
    const auto receivers = receivers_for(of_map, size, random);
    const auto clamped_fetch = [&](glm::ivec2 t) {
        t = {t.x < 0 ? 0 : std::min(t.x, of_map.x - 1), t.y < 0 ? 0 : std::min(t.y, of_map.y - 1)};
        return encoding.decode(map[t]);
    };
    const auto bordered_fetch = [&](glm::ivec2 t) {
        return t.x >= 0 && t.y >= 0 && t.x < of_map.x && t.y < of_map.y ? encoding.decode(map[t]) : 1.0f;
    };
    image<float> by_default(size, -7.0f), at_edge(size, -7.0f);
    visibility(map.view(), encoding, receivers.view(), filter, by_default.view());
    visibility(map.view(), encoding, receivers.view(), filter, at_edge.view(), serial{}, outside_map::clamped);
    int differ = 0;
    const auto compare = [&](float expected, float got) {
        differ += std::bit_cast<std::uint32_t>(got) != std::bit_cast<std::uint32_t>(expected);
    };
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::vec3 r = receivers[{x, y}];
            compare(primitive(bordered_fetch, glm::vec2(r), r.z), by_default[{x, y}]);
            compare(primitive(clamped_fetch, glm::vec2(r), r.z), at_edge[{x, y}]);
        }
    return differ;
}

template <class Encoding>
int differing_for_all_filters(Encoding encoding, glm::ivec2 of_map, glm::ivec2 size, unsigned seed) {
    int differ = differing(
        encoding, of_map, size, filters::hard{}, [](auto& f, glm::vec2 c, float z) { return hard(f, c, z); }, seed);
    differ += differing(
        encoding, of_map, size, filters::four_tap{},
        [](auto& f, glm::vec2 c, float z) {
            const glm::vec2 h(0.5f, 0.5f), g(0.5f, -0.5f);
            return four_tap(f, c - h, c + g, c - g, c + h, z);
        },
        seed + 1);
    const std::array offsets{glm::vec2(1.25f, 0), glm::vec2(-3, 2), glm::vec2(0, -0.125f), glm::vec2(0)};
    differ += differing(
        encoding, of_map, size, filters::four_tap{offsets},
        [&](auto& f, glm::vec2 c, float z) {
            return four_tap(f, c + offsets[0], c + offsets[1], c + offsets[2], c + offsets[3], z);
        },
        seed + 2);
    differ += differing(
        encoding, of_map, size, filters::pcf_2x2{}, [](auto& f, glm::vec2 c, float z) { return pcf_2x2(f, c, z); },
        seed + 3);
    for (float epsilon : {0.0f, 0.125f})
        differ += differing(
            encoding, of_map, size, filters::pcf_2x2_dx_sdk{epsilon},
            [&](auto& f, glm::vec2 c, float z) { return pcf_2x2_dx_sdk(f, c, z, epsilon); }, seed + 4);
    for (int radius : {-1, 0, 1, 2, 3, 5, 8, 100})
        differ += differing(
            encoding, of_map, size, filters::box{radius},
            [&](auto& f, glm::vec2 c, float z) { return box(f, c, z, radius); }, seed + 5);
    return differ;
}

/// Depths as they are, and nothing of which way they run.
struct undirected {
    using texel = float;
    [[nodiscard]] float encode(float depth) const { return depth; }
    [[nodiscard]] float decode(float t) const { return t; }
};

}  // namespace

// Other encodings: proof/blocks/every_path.
TEST_CASE("visibility: the primitive's bits at every pixel, for every filter") {
    unsigned seed = 1;
    // a map of ordinary size, and maps smaller than the filters' reach
    for (glm::ivec2 of_map : {glm::ivec2(67, 41), glm::ivec2(1, 1), glm::ivec2(2, 1), glm::ivec2(1, 9),
                              glm::ivec2(3, 2), glm::ivec2(16, 17)})
        for (glm::ivec2 size : {glm::ivec2(133, rounds(21)), glm::ivec2(1, 3)}) {
            CAPTURE(of_map.x);
            CAPTURE(size.x);
            CHECK(differing_for_all_filters(rg<11>{}, of_map, size, seed += 10) == 0);
            CHECK(differing_for_all_filters(rg<11>{.edge = lower_edge<float>}, of_map, size, seed += 10) == 0);
            CHECK(differing_for_all_filters(depth32f{}, of_map, size, seed += 10) == 0);
        }
}

TEST_CASE("visibility: any callable is a filter, reversed maps among them") {
    const auto reversed = [](auto& f, glm::vec2 c, float z) { return pcf_2x2(f, c, z, greater_equal{}); };
    CHECK(differing(rg<11>{.edge = lower_edge<float>}, {9, 8}, {70, 3}, reversed, reversed, 1) == 0);
    const auto receiver_itself = [](auto&, glm::vec2, float z) { return z; };
    CHECK(differing(depth32f{}, {9, 8}, {200, 3}, receiver_itself, receiver_itself, 2) == 0);
}

TEST_CASE("visibility: by hand") {
    image<float> map({2, 2}, 0.5f);
    map[{1, 0}] = 1.0f;
    image<glm::vec3> receivers({3, 1});
    receivers[{0, 0}] = {0.5f, 0.5f, 0.5f};   // at the stored depth
    receivers[{1, 0}] = {1.0f, 0.5f, 0.75f};  // between a nearer and a farther occluder
    receivers[{2, 0}] = {65536, 65536, 0};    // behind the light
    image<float> out({3, 1});
    visibility(map.view(), depth32f{}, receivers.view(), filters::pcf_2x2{}, out.view());
    CHECK(out[{0, 0}] == 1.0f);
    CHECK(out[{1, 0}] == 0.5f);
    CHECK(out[{2, 0}] == 1.0f);
    visibility(map.view(), depth32f{}, receivers.view(), filters::box{1}, out.view());
    CHECK(out[{1, 0}] == 6.0f * (1.0f / 9.0f));  // the lit texel, and those outside the map
    visibility(map.view(), depth32f{}, receivers.view(), filters::box{1}, out.view(), serial{}, outside_map::clamped);
    CHECK(out[{1, 0}] == 4.0f * (1.0f / 9.0f));  // the lit texel, and the copies of it outside the map
}

TEST_CASE("visibility: rows with gaps, rows from the bottom up; the gaps stay as they were") {
    std::mt19937 random(3);
    const glm::ivec2 size(71, 9), of_map(13, 11);
    const auto map = packed_map(rg<11>{}, of_map, random);
    const auto receivers = receivers_for(of_map, size, random);
    image<float> plain(size);
    visibility(map.view(), rg<11>{}, receivers.view(), filters::box{2}, plain.view());

    // the same three images inside wider ones, each upside down in memory
    image<glm::u8vec2> wide_map({of_map.x + 3, of_map.y}, glm::u8vec2(77));
    image<glm::vec3> wide_receivers({size.x + 5, size.y}, glm::vec3(-3));
    image<float> wide_out({size.x + 1, size.y}, -5.0f);
    const auto flipped = [](auto& whole, glm::ivec2 part) {
        const auto view = whole.view();
        return image_view(view.row(part.y - 1), part, -view.stride);
    };
    const auto map_view = flipped(wide_map, of_map);
    const auto receiver_view = flipped(wide_receivers, size);
    const auto out_view = flipped(wide_out, size);
    for (int y = 0; y < of_map.y; ++y)
        for (int x = 0; x < of_map.x; ++x) map_view[{x, y}] = map[{x, y}];
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) receiver_view[{x, y}] = receivers[{x, y}];
    visibility(map_view, rg<11>{}, receiver_view, filters::box{2}, out_view);
    int differ = 0, partly = 0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            differ += out_view[{x, y}] != plain[{x, y}];
            partly += plain[{x, y}] > 0 && plain[{x, y}] < 1;
        }
        CHECK(wide_out[{size.x, y}] == -5.0f);
    }
    CHECK(differ == 0);
    CHECK(partly > 50);
}

TEST_CASE("visibility: empty receivers, sizes that differ, an empty map") {
    image<float> map({2, 2}, 1.0f), out({3, 2}, -1.0f), none;
    image<glm::vec3> receivers({3, 2}), turned({2, 3}), no_receivers;
    const auto run = [](const auto& m, const auto& r, auto& o) {
        visibility(m.view(), depth32f{}, r.view(), filters::hard{}, o.view());
    };
    CHECK_NOTHROW(run(map, no_receivers, none));
    image<float> zero_wide({0, 4});
    image<glm::vec3> zero_wide_receivers({0, 4});
    CHECK_NOTHROW(run(map, zero_wide_receivers, zero_wide));
    CHECK_THROWS_AS(run(map, turned, out), std::invalid_argument);
    CHECK_THROWS_AS(run(map, no_receivers, out), std::invalid_argument);
    CHECK_THROWS_AS(run(map, receivers, none), std::invalid_argument);
    CHECK_THROWS_AS(run(none, receivers, out), std::invalid_argument);
    CHECK_THROWS_AS(run(none, no_receivers, none), std::invalid_argument);
    for (float v : out.texels()) CHECK(v == -1.0f);  // whoever threw wrote nothing
}

TEST_CASE("visibility: the map's direction holds, or the filter's where the encoding has none") {
    const image<glm::vec3> receivers({3, 1}, {0.5f, 0.5f, 0.5f});
    image<float> out({3, 1});
    const auto of = [&](const auto& encoding, const auto& filter, float stored) {
        const image<typename std::decay_t<decltype(encoding)>::texel> map({5, 5}, encoding.encode(stored));
        visibility(map, encoding, receivers, filter, out);
        return out[{1, 0}];
    };
    for (const auto own : {depth_direction::forward, depth_direction::reversed}) {
        CHECK(of(depth32f{depth_direction::forward}, filters::hard{.direction = own}, 0.25f) == 0.0f);
        CHECK(of(depth32f{depth_direction::reversed}, filters::hard{.direction = own}, 0.25f) == 1.0f);
        CHECK(of(rgb24{.direction = depth_direction::reversed}, filters::hard{.direction = own}, 0.75f) == 0.0f);
        CHECK(of(undirected{}, filters::hard{.direction = own}, 0.25f) ==
              (own == depth_direction::forward ? 0.0f : 1.0f));
    }
    const auto own_callable = [](const auto& fetch, glm::vec2, float receiver) {
        return receiver <= fetch(glm::ivec2(0, 0)) ? 1.0f : 0.0f;
    };
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        CHECK(of(depth32f{direction}, own_callable, 0.75f) == 1.0f);
}

TEST_CASE("receiver_matrix: from a camera's texel and depth to where the world point falls on the map") {
    const glm::mat4 to_texels{{300, 0, 0, 0}, {0, 200, 0, 0.5f}, {0, 0, 0.25f, 0}, {10, 20, 0.5f, 2}};
    glm::mat4 world_to_clip(0.0f);
    world_to_clip[0][0] = 1.5f, world_to_clip[1][1] = 2.0f, world_to_clip[2][2] = -1.25f, world_to_clip[3][2] = -2.5f;
    world_to_clip[2][3] = -1.0f;
    const glm::ivec2 size(64, 48);
    for (auto range : {depth_range::zero_to_one, depth_range::minus_one_to_one})
        for (auto origin : {texture_origin::bottom, texture_origin::top}) {
            const clip_space clip{.range = range, .origin = origin};
            const glm::mat4 m = receiver_matrix(glm::inverse(world_to_clip), to_texels, size, clip);
            const glm::vec3 world(0.3f, -0.4f, -5.0f);
            const glm::vec4 h = world_to_clip * glm::vec4(world, 1.0f);
            glm::vec3 seen = glm::vec3(h) / h.w;
            if (range == depth_range::minus_one_to_one) seen.z = depth_from_ndc(seen.z);
            const float up = origin == texture_origin::bottom ? seen.y : -seen.y;
            const glm::vec3 texel((seen.x * 0.5f + 0.5f) * 64.0f, (up * 0.5f + 0.5f) * 48.0f, seen.z);
            const glm::vec3 there = project_coordinate(shadow_coordinate(m, texel));
            CHECK(glm::length(there - project_coordinate(shadow_coordinate(to_texels, world))) < 1e-3f);
        }
    CHECK_THROWS_AS((void)receiver_matrix(glm::mat4(1), to_texels, {0, 1}, cpu_clip_space), std::invalid_argument);
    CHECK_THROWS_AS((void)receiver_matrix(glm::mat4(1), to_texels, {1, -1}, cpu_clip_space), std::invalid_argument);
    const glm::mat4 flat(glm::inverse(glm::mat4(0.0f)));  // no camera
    CHECK_THROWS_AS((void)receiver_matrix(flat, to_texels, size, cpu_clip_space), std::invalid_argument);
    CHECK_THROWS_AS((void)receiver_matrix(glm::mat4(3e38f), to_texels, size, cpu_clip_space), std::invalid_argument);
}
