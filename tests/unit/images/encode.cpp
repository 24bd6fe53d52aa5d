// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <umbrage/images/encode.hpp>

using namespace umbrage;

namespace {

image<float> depths() {
    image<float> map({7, 5});
    for (int i = 0; i < 35; ++i) map[{i % 7, i / 7}] = float(i) / 29.0f - 0.1f;  // some below 0, some above 1
    map[{3, 3}] = std::numeric_limits<float>::quiet_NaN();
    return map;
}

template <class Encoding>
void is_the_primitive_at_every_texel(Encoding encoding) {
    const auto map = depths();
    image<typename Encoding::texel> texels(map.size());
    image<float> back(map.size());
    encode(map.view(), texels.view(), encoding);
    decode<Encoding>(texels.view(), back.view(), encoding);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) {
            CHECK(texels[{x, y}] == encoding.encode(map[{x, y}]));
            const float expected = encoding.decode(encoding.encode(map[{x, y}]));
            CHECK((back[{x, y}] == expected || (is_nan(back[{x, y}]) && is_nan(expected))));
        }
}

}  // namespace

TEST_CASE("encode, decode: images are the primitive at every texel") {
    is_the_primitive_at_every_texel(rg<9>{});
    is_the_primitive_at_every_texel(rg<11>{.edge = lower_edge<float>});
    is_the_primitive_at_every_texel(rg<16>{});
    is_the_primitive_at_every_texel(rgb24{});
    is_the_primitive_at_every_texel(float_bits{});
    is_the_primitive_at_every_texel(depth32f{});
}

TEST_CASE("encode: large images, which bypass the cache, with some texels behind the last whole block") {
    image<float> map({1100, 2000});
    std::uint32_t bits = 1;
    for (float& depth : map.texels())
        depth = static_cast<float>((bits = bits * 1664525u + 1013904223u) >> 8) * 0x1p-24f;
    image<glm::u8vec2> texels(map.size());
    encode(map, texels, rg<11>{});
    int wrong = 0;
    for (int y = 0; y < map.size().y; ++y)
        for (int x = 0; x < map.size().x; ++x) wrong += texels[{x, y}] != encode_rg<11>(map[{x, y}]);
    CHECK(wrong == 0);
}

TEST_CASE("encode, decode: strided and bottom-up views; what lies between rows stays") {
    const auto map = depths();
    std::vector<glm::u8vec2> buffer(9 * 5, glm::u8vec2(1, 2));
    const std::ptrdiff_t row = 9 * sizeof(glm::u8vec2);
    encode(map.view(), image_view<glm::u8vec2>(buffer.data() + 9 * 4, {7, 5}, -row), rg<11>{});
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 7; ++x) CHECK(buffer[std::size_t((4 - y) * 9 + x)] == encode_rg<11>(map[{x, y}]));
        for (int x = 7; x < 9; ++x) CHECK(buffer[std::size_t((4 - y) * 9 + x)] == glm::u8vec2(1, 2));
    }
    image<float> back({7, 5});
    decode(image_view<const glm::u8vec2>(buffer.data(), {7, 5}, row), back.view(), rg<11>{});
    CHECK(back[{6, 0}] == rg<11>{}.decode(encode_rg<11>(map[{6, 4}])));
}

TEST_CASE("encode, decode: nothing to do, and sizes that differ") {
    image<glm::u8vec2> texels({3, 3}), none;
    image<float> map({3, 2}), empty;
    CHECK_NOTHROW(encode(empty.view(), none.view(), rg<11>{}));
    CHECK_NOTHROW(decode<rg<11>>(none.view(), empty.view(), rg<11>{}));
    CHECK_THROWS_AS(encode(map.view(), texels.view(), rg<11>{}), std::invalid_argument);
    CHECK_THROWS_AS(decode<rg<11>>(texels.view(), map.view(), rg<11>{}), std::invalid_argument);
    CHECK_THROWS_AS(encode(empty.view(), texels.view(), rg<11>{}), std::invalid_argument);
}
