// SPDX-License-Identifier: MIT
//
// Every filter under every setup, which takes minutes to compile; unit/shadow has one of each.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "../unit/fusing.hpp"
#include "../unit/images/last_piece_first.hpp"
#include "../unit/shadow/scene.hpp"

using namespace umbrage;
using namespace shadow_scene;

namespace {

/// Points in rows on the floor, of which most tiles see one map; points anywhere; NaN, far away, behind the light.
image<glm::vec3> some_receivers() {
    const glm::ivec2 size(150, 70);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> anywhere(-22, 22);
    image<glm::vec3> points(size);
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x)
            points[p] = p.y < size.y / 2 ? glm::vec3(float(p.x) * 0.1f - 8, 0, float(p.y) * 0.1f - 4)
                                         : glm::vec3(anywhere(random), 0, anywhere(random));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    points[{1, 1}] = glm::vec3(nan), points[{2, 1}] = glm::vec3(0.5f, 8, 0.25f), points[{3, 1}] = glm::vec3(1e30f);
    points[{4, 1}] = glm::vec3(0, -300, 0), points[{5, 1}] = glm::vec3(0, 300, 0), points[{6, 1}].y = nan;
    return points;
}

/// Pieces of three rows, which begin between the rows of a disc's pattern.
constexpr auto in_threes = [](int count, const auto& use) {
    for (int first = 0; first < count; first += 3) use(first, std::min(first + 3, count));
};

template <class Filter, class Encoding>
void compare(const Filter& filter, const Encoding& encoding) {
    const auto points = some_receivers();
    image<glm::vec3> normals(points.size(), glm::vec3(0.1f, 1, 0.2f));
    normals[{9, 9}] = glm::vec3(0), normals[{10, 9}] = glm::vec3(3, 1, -2);
    for_each_shadow(unity_clip_space, filter, encoding, [&](const auto& s) {
        const auto map = drawn(s);
        image<float> whole(points.size()), rows(points.size()), split(points.size());
        s.visibility(map, points, normals, whole);
        s.visibility(map, points, normals, rows, in_threes);
        s.visibility(map, points, normals, split, last_piece_first{5});
        int wrong = 0, dark = 0;
        for (glm::ivec2 p(0); p.y < points.size().y; ++p.y)
            for (p.x = 0; p.x < points.size().x; ++p.x) {
                const float alone = s(map, points[p], normals[p], p);
                for (const auto* image : {&whole, &rows, &split})
                    wrong += std::bit_cast<std::uint32_t>((*image)[p]) != std::bit_cast<std::uint32_t>(alone);
                dark += alone < 1;
            }
        // fused, ties fall either way: in 1/20 of each image
        CHECK(wrong <= (may_fuse ? 3 * (points.size().x * points.size().y / 20) : 0));
        CHECK(dark > 30);
    });
}

}  // namespace

TEST_CASE("every shadow: an image has the visibilities of its receivers alone, in pieces of any order") {
    compare(filters::disc{}, rg<11>{});
    compare(sized(filters::pcss{}), depth32f{});
    compare(filters::pcf_2x2{}, rg<11>{});
    compare(filters::castano<5>, rg<11>{});
    compare(prefilters::vsm{}, moment_texels<prefilters::vsm>{});
    compare(prefilters::evsm4{}, moment_texels<prefilters::evsm4>{});
}

TEST_CASE("every shadow: filters and encodings take the light's direction of depth") {
    for (const clip_space clip : {cpu_clip_space, unity_clip_space})
        for_each_light(clip, [&]<class Light>(const Light& light, glm::ivec2 map_size) {
            image<float> depths;
            const auto check = [&]<class Filter>(const Filter& filter, const auto& encoding) {
                if constexpr (go_together<Light, Filter>) {
                    const shadow s(light, map_size, filter, encoding);
                    if (depths.empty()) depths = depths_of(s);
                    const auto map = stored(s, depths);
                    CHECK(s(map, {0, 0, 0}, up) < 0.5f);
                    CHECK(s(map, {7, 0, 6}, up) == 1.0f);
                    CHECK(s(map, {0, 2, 0}, up) == 1.0f);
                }
            };
            for_each_filter([&]<class Filter>(const Filter& filter) {
                if constexpr (detail::point_filter<Filter>) check(filter, rg<16>{});
            });
            filters::soft::for_each([&](const auto& filter) { check(sized(filter), depth32f{}); });
            check(filters::pcf_2x2{}, depth32f{});
            check(filters::pcf_2x2{}, rg<11>{});
        });
}
