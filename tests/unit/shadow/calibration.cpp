// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/r16.hpp>
#include <umbrage/shadow/calibration.hpp>

#include "scene.hpp"

using namespace umbrage;

namespace {

template <class Shadow>
constexpr int maps_of = std::remove_cvref_t<decltype(std::declval<Shadow>().setup())>::grid
                            .columns* std::remove_cvref_t<decltype(std::declval<Shadow>().setup())>::grid.rows;

/// Each map upside down.
template <class Texel>
image<Texel> flipped_rows(const image<Texel>& map, glm::ivec2 map_size) {
    image<Texel> out = map;
    for (int y = 0; y < map.size().y; ++y) {
        const int row = y % map_size.y;
        std::copy_n(map.view().row(y - row + map_size.y - 1 - row), map.size().x, out.view().row(y));
    }
    return out;
}

/// The first map's content in all of them.
template <class Texel>
image<Texel> first_everywhere(const image<Texel>& map, glm::ivec2 map_size) {
    image<Texel> out = map;
    for (int y = 0; y < map.size().y; ++y)
        for (int x = 0; x < map.size().x; x += map_size.x)
            std::copy_n(map.view().row(y % map_size.y), map_size.x, out.view().row(y) + x);
    return out;
}

template <class Filter, class Encoding>
void all_readings(clip_space clip, const Filter& filter, const Encoding& encoding) {
    shadow_scene::for_each_shadow(clip, filter, encoding, [&](const auto& s) {
        const auto known = calibration_map(s);
        CAPTURE(known.size().x);
        CAPTURE(filter.snippet->name);
        const int last = maps_of<decltype(s)> - 1;
        for (int number = 0; number <= last; ++number) CHECK(calibrate(s, known, number) == map_reading::right);
        CHECK(calibrate(s, flipped_rows(known, s.map_size()), last) == map_reading::upside_down);
        auto other = known;
        std::fill(other.texels().begin(), other.texels().end(), s.cleared());
        CHECK(calibrate(s, other, last) == map_reading::empty);
        const auto shared = first_everywhere(known, s.map_size());
        CHECK(calibrate(s, shared, 0) == map_reading::right);
        if (last > 0) CHECK(calibrate(s, shared, last) == map_reading::another_map);
    });
}

clip_space reversed_clip() {
    clip_space clip = cpu_clip_space;
    clip.direction = depth_direction::reversed;
    return clip;
}

}  // namespace

TEST_CASE("calibration: right, upside down, empty and another map, for each setup") {
    all_readings(cpu_clip_space, filters::pcf_2x2{}, depth32f{});
    all_readings(reversed_clip(), filters::tent<3>, rg<11>{});
    all_readings(cpu_clip_space, filters::disc{}, r16{});
    all_readings(reversed_clip(), shadow_scene::sized(filters::pcss{}), depth32f{});
}

TEST_CASE("calibration: prefiltered maps") {
    const auto known_and_flipped = [](const auto& filter) {
        for (const clip_space clip : {cpu_clip_space, reversed_clip()}) {
            const shadow s(shadow_scene::spot(clip), {64, 64}, filter);
            CAPTURE(filter.name);
            CHECK(calibrate(s, calibration_map(s), 0) == map_reading::right);
            CHECK(calibrate(s, flipped_rows(calibration_map(s), s.map_size()), 0) == map_reading::upside_down);
        }
    };
    known_and_flipped(prefilters::vsm{});
    known_and_flipped(prefilters::esm{});
    known_and_flipped(prefilters::evsm2{});
    known_and_flipped(prefilters::evsm4{});
    known_and_flipped(prefilters::msm{});
}

TEST_CASE("calibration: dark, coarse, reversed and wrong") {
    const shadow s(shadow_scene::spot(cpu_clip_space), {64, 32}, filters::pcf_2x2{});
    const auto known = calibration_map(s);
    const auto changed = [&](const auto& change) {
        auto map = known;
        for (float& depth : map.texels()) depth = change(depth);
        return calibrate(s, map, 0);
    };
    CHECK(changed([](float) { return 0.0f; }) == map_reading::dark);
    CHECK(changed([](float) { return std::numeric_limits<float>::quiet_NaN(); }) == map_reading::dark);
    CHECK(changed([](float d) { return std::round(d * 255.0f) / 255.0f; }) == map_reading::coarse);
    CHECK(changed([](float d) { return std::round(d * 65535.0f) / 65535.0f; }) == map_reading::coarse);
    CHECK(changed([](float d) { return std::round(d * 16777215.0f) / 16777215.0f; }) == map_reading::right);
    CHECK(changed([](float d) { return std::pow(d, 2.2f); }) == map_reading::wrong);
    CHECK(changed([](float d) { return d * 0.5f; }) == map_reading::wrong);

    clip_space other = cpu_clip_space;
    other.direction = depth_direction::reversed;
    const shadow reversed(shadow_scene::spot(other), {64, 32}, filters::pcf_2x2{});
    CHECK(calibrate(reversed, known, 0) == map_reading::wrong);  // depths of the other direction, compared as asked
}

TEST_CASE("calibration: a packed map whose channels are lost or swapped") {
    const shadow s(shadow_scene::spot(cpu_clip_space), {64, 64}, filters::tent<3>, rg<11>{});
    auto map = calibration_map(s);
    CHECK(calibrate(s, map, 0) == map_reading::right);
    for (auto& texel : map.texels()) std::swap(texel.x, texel.y);
    CHECK(calibrate(s, map, 0) == map_reading::wrong);
    for (auto& texel : map.texels()) texel.x = 0;
    CHECK(calibrate(s, map, 0) == map_reading::wrong);
    const shadow fine(shadow_scene::spot(cpu_clip_space), {64, 64}, filters::tent<3>, rg<16>{});
    auto bytes = calibration_map(fine);
    CHECK(calibrate(fine, bytes, 0) == map_reading::right);
    for (auto& texel : bytes.texels()) texel.x = 0;
    CHECK(calibrate(fine, bytes, 0) == map_reading::coarse);
}

TEST_CASE("calibration: bad input, and a sentence for each reading") {
    const shadow s(shadow_scene::spot(cpu_clip_space), {8, 8}, filters::box{.radius = 2});
    CHECK_THROWS_WITH((void)calibration_map(s),
                      doctest::Contains("of.map_size() must be four times the filter's reach"));
    const shadow t(shadow_scene::spot(cpu_clip_space), {32, 32}, filters::box{.radius = 2});
    CHECK_THROWS_WITH((void)calibrate(t, calibration_map(t), 1),
                      doctest::Contains("number must be one of the light's maps"));
    CHECK_THROWS_WITH((void)calibrate(t, image<float>({31, 32}), 0), doctest::Contains("map.size"));
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < i; ++k)
            CHECK(std::string_view(explain(map_reading(i))) != std::string_view(explain(map_reading(k))));
}
