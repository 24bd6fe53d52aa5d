// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include <umbrage/debug/overlay.hpp>

using namespace umbrage;

namespace {

const glm::u8vec3 backdrop(7, 8, 9);
const auto identity = [](float v) { return v; };

image<float> two_by_two() {  // 0.2 0.4 in row 0, 0.6 0.8 in row 1
    image<float> map({2, 2});
    map[{0, 0}] = 0.2f, map[{1, 0}] = 0.4f, map[{0, 1}] = 0.6f, map[{1, 1}] = 0.8f;
    return map;
}

}  // namespace

TEST_CASE("overlay: the top left corner as people see it, for each origin of map and picture") {
    const auto map = two_by_two();
    for (auto map_origin : {texture_origin::bottom, texture_origin::top})
        for (auto picture_origin : {texture_origin::bottom, texture_origin::top}) {
            image<glm::u8vec3> picture({5, 4}, backdrop);
            overlay(picture, map, {.map_origin = map_origin, .picture_origin = picture_origin}, identity);
            for (int y = 0; y < 4; ++y)  // from the top
                for (int x = 0; x < 5; ++x) {
                    auto expected = backdrop;
                    if (x < 2 && y < 2)
                        expected = glm::ivec3(51 * (1 + x + 2 * (map_origin == texture_origin::top ? y : 1 - y)));
                    CHECK(picture[{x, picture_origin == texture_origin::top ? y : 3 - y}] == expected);
                }
        }
}

TEST_CASE("overlay: scaled to the nearest texel and cut off at the picture's border") {
    const auto map = two_by_two();
    image<glm::u8vec3> picture({5, 3}, backdrop);
    overlay(picture, map, {.size = {4, 6}, .map_origin = texture_origin::top}, identity);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) CHECK(picture[{x, y}] == (x < 4 ? glm::u8vec3(x < 2 ? 51 : 102) : backdrop));

    image<glm::u8vec3> tiny({1, 1}, backdrop);
    overlay(tiny, map, {.size = {1 << 30, 1 << 30}, .map_origin = texture_origin::top}, identity);
    CHECK(tiny[{0, 0}] == glm::u8vec3(51));
    overlay(tiny, map, {.size = {1, 1}, .map_origin = texture_origin::top}, identity);
    CHECK(tiny[{0, 0}] == glm::u8vec3(204));  // the texel right and below of the map's middle
}

TEST_CASE("overlay: colors, NaN, nothing to draw, bad sizes") {
    auto map = two_by_two();
    image<glm::u8vec3> picture({2, 2}, backdrop);
    overlay(picture, map, {}, [](float v) { return glm::vec3(v, 0.0f, 2.0f); });
    CHECK(picture[{0, 1}] == glm::u8vec3(51, 0, 255));

    map[{0, 1}] = std::numeric_limits<float>::quiet_NaN();
    overlay(picture, map, {}, stretch(map));
    CHECK(picture[{0, 0}] == glm::u8vec3(255));

    image<glm::u8vec3> untouched({2, 2}, backdrop);
    overlay(untouched, image_view<const float>{}, {.size = {2, 2}}, identity);
    for (auto texel : untouched.texels()) CHECK(texel == backdrop);
    overlay(image_view<glm::u8vec3>{}, map, {}, identity);
    CHECK_THROWS_AS(overlay(picture, map, {.size = {-1, 1}}, identity), std::invalid_argument);
}

TEST_CASE("stretch: the range of what was drawn, without cleared texels, NaN and outliers") {
    image<float> map({20, 10}, 1.0f);
    CHECK(stretch(map).low == 0.0f);
    CHECK(stretch(map).high == 1.0f);
    CHECK(stretch(image_view<const float>{}).high == 1.0f);

    for (int i = 0; i < 100; ++i) map[{i % 20, i / 20}] = 0.25f + 0.001f * float((i * 37) % 100);  // shuffled
    map[{0, 9}] = std::numeric_limits<float>::infinity();
    map[{1, 9}] = std::numeric_limits<float>::quiet_NaN();
    CHECK(stretch(map, 1.0f, 0.0).low == 0.25f);
    CHECK(stretch(map, 1.0f, 0.0).high == 0.25f + 0.001f * 99.0f);
    CHECK(stretch(map).low == 0.25f + 0.001f * 1.0f);
    CHECK(stretch(map).high == 0.25f + 0.001f * 98.0f);
    CHECK(stretch(map, 0.25f, 0.0).low == 0.25f + 0.001f);  // another cleared value, as when depth is reversed
    CHECK(stretch(map, 0.25f, 0.0).high == 1.0f);

    const contrast_stretch s{0.25f, 0.75f};
    CHECK(s(0.0f) == 0.0f);
    CHECK(s(0.25f) == 0.0f);
    CHECK(s(0.375f) == 0.25f);
    CHECK(s(0.75f) == 1.0f);
    CHECK(s(2.0f) == 1.0f);
    CHECK(s(std::numeric_limits<float>::quiet_NaN()) == 1.0f);
    const contrast_stretch flat{0.5f, 0.5f};  // one depth only
    CHECK(flat(0.4f) == 0.0f);
    CHECK(flat(0.5f) == 1.0f);

    CHECK_THROWS_AS((void)stretch(map, 1.0f, 0.5), std::invalid_argument);
    CHECK_THROWS_AS((void)stretch(map, 1.0f, -0.1), std::invalid_argument);
    CHECK_THROWS_AS((void)stretch(map, 1.0f, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}
