// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>

#include <umbrage/shadow/frame.hpp>

#include "scene.hpp"
#include "texts.hpp"

using namespace umbrage;
using detail::blended;
using detail::frame_words_of;
using shadow_texts::has;

TEST_CASE("frame: a second place counts by its weight; one without weight is not looked up") {
    std::array<map_place, 2> places{map_place{.number = 1}, {.number = 3, .weight = 0.25f}};
    int looks = 0;
    const auto number = [&](const map_place& p) { return ++looks, float(p.number); };
    CHECK(blended(places, number) == 1.5f);
    places[1].weight = 1.0f;
    CHECK(blended(places, number) == 3.0f);
    places[1].weight = 0.0f;
    looks = 0;
    CHECK(blended(places, number) == 1.0f);
    CHECK(looks == 1);
    places[1].weight = 0.5f;
    CHECK(blended(places, [](const map_place& p) { return glm::vec3(p.number, 0, 1); }) == glm::vec3(2, 0, 1));
}

TEST_CASE("frame: one text, with a loop of lookups and a choice of the map only where there are such") {
    const detail::frame_result one{
        .head = "float f(", .type = "float", .lit = "1.0", .look = "look(at)", .blend = "mix"};
    const auto text = [&](const detail::frame_words& w) { return detail::frame_text(one, w, w.chooses_map); };
    const clip_space clip = cpu_clip_space;
    const single_map lamp(shadow_scene::spot(clip)), sun(shadow_scene::fitted(clip));
    const std::string single = text(frame_words_of(lamp, false, false)),
                      parallel = text(frame_words_of(sun, false, false)),
                      atlas = text(frame_words_of(cascaded_maps(shadow_scene::cascades<4>(clip)), false, true)),
                      array = text(frame_words_of(cube_maps(shadow_scene::bulb(clip)), true, false));
    CHECK(has(single, "float f(UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes, UMBRAGE_HIGHP vec4 anchor"));
    CHECK(has(single,
              "place = umbrage_single_map_places(to_texels, planes, anchor, rounding, slack, terms, world, normal);"));
    CHECK(has(parallel, "place = umbrage_parallel_map_places(to_texels, planes,"));
    CHECK(!has(single, "choice"));
    CHECK(!has(single, "origin"));
    CHECK(has(atlas, "vec2 origin = umbrage_map_tile(number, vec2(2.0, 1.0 / 2.0), vec2(terms.x, terms.y));"));
    CHECK(has(atlas, "for (int i = 0; i < count; ++i) {"));
    CHECK(has(atlas, "vec3 normal, UMBRAGE_HIGHP vec2 pixel) {"));
    CHECK(has(atlas,
              "choice = umbrage_cascaded_maps_choice(rotation, scales, offsets, anchor, blending, terms, world);"));
    CHECK(has(atlas, "if (weight > 0.0) {"));
    CHECK(has(atlas, "terms, world, normal, chosen);"));
    CHECK(has(array, "float layer = number;"));
    CHECK(!has(array, "weight"));
    CHECK(!has(array, "for ("));
}
