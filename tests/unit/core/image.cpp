// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>

using namespace umbrage;
using glm::ivec2;

namespace {

image<int> counted(ivec2 size) {  // texel (x, y) is 10 y + x
    image<int> map(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) map[{x, y}] = 10 * y + x;
    return map;
}

static_assert(std::is_convertible_v<image_view<int>, image_view<const int>>);
static_assert(!std::is_convertible_v<image_view<const int>, image_view<int>>);
static_assert(!std::is_convertible_v<const image<int>&, image_view<int>>);

}  // namespace

TEST_CASE("image_view: rows of a foreign buffer, with and without padding") {
    std::array<int, 15> pixels{};
    for (int i = 0; i < 15; ++i) pixels[std::size_t(i)] = i;
    const image_view<int> tight(pixels.data(), {5, 3});
    CHECK(tight.stride == 5 * int(sizeof(int)));
    CHECK(tight[{4, 2}] == 14);
    const image_view<const int> padded(pixels.data(), {3, 3}, 5 * sizeof(int));  // 2 ints of padding
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) CHECK(padded[{x, y}] == 5 * y + x);
    tight[{1, 1}] = 99;
    CHECK(padded[{1, 1}] == 99);
}

TEST_CASE("image_view: a negative stride shows a bottom-up image the right way round") {
    std::array<int, 6> pixels{0, 1, 10, 11, 20, 21};
    const image_view<int> flipped(pixels.data() + 4, {2, 3}, -2 * std::ptrdiff_t(sizeof(int)));
    CHECK(flipped[{0, 0}] == 20);
    CHECK(flipped[{1, 1}] == 11);
    CHECK(flipped[{1, 2}] == 1);
    const auto band = flipped.rows(1, 3);
    CHECK(band.size == ivec2(2, 2));
    CHECK(band[{0, 0}] == 10);
    CHECK(band[{1, 1}] == 1);
}

TEST_CASE("image_view: rows whose stride is no multiple of the texel") {
    std::array<std::uint8_t, 8> bytes{1, 2, 3, 0, 4, 5, 6, 0};  // RGB rows padded to four bytes
    const image_view<const glm::vec<3, std::uint8_t>> view(
        reinterpret_cast<const glm::vec<3, std::uint8_t>*>(bytes.data()), {1, 2}, 4);
    CHECK(view[{0, 1}] == glm::vec<3, std::uint8_t>(4, 5, 6));
}

TEST_CASE("image_view: bands of rows cover the view, empty bands are views too") {
    auto map = counted({3, 4});
    const auto view = map.view();
    CHECK(view.rows(0, 4).size == view.size);
    CHECK(view.rows(2, 4)[{2, 1}] == 32);
    CHECK(view.rows(4, 4).empty());
    CHECK(view.rows(0, 0).empty());
}

TEST_CASE("image_view: nothing to view") {
    CHECK(image_view<int>().empty());
    for (ivec2 size : {ivec2(0, 0), ivec2(5, 0), ivec2(0, 5)}) {
        CHECK(image_view<int>(nullptr, size).empty());
        CHECK(image_view<int>(nullptr, size, 1).empty());  // no row, so no stride to be wrong
        CHECK(image_view<int>(nullptr, size).rows(0, 0).empty());
        CHECK(image<int>(size).empty());
        CHECK(image<int>(size).size() == size);
        CHECK(image<int>(size).view().empty());
    }
    CHECK(image<int>().view().empty());
}

TEST_CASE("image_view: bad input") {
    std::array<int, 16> pixels{};
    const auto make = [&](int* data, ivec2 size, std::ptrdiff_t stride) { (void)image_view<int>(data, size, stride); };
    CHECK_THROWS_AS(make(pixels.data(), {-1, 2}, 8), std::invalid_argument);
    CHECK_THROWS_AS(make(pixels.data(), {2, -1}, 8), std::invalid_argument);
    CHECK_THROWS_AS(make(pixels.data(), {0, -1}, 8), std::invalid_argument);
    CHECK_THROWS_AS(make(nullptr, {2, 2}, 8), std::invalid_argument);
    CHECK_THROWS_AS(make(pixels.data(), {2, 2}, 4), std::invalid_argument);
    CHECK_THROWS_AS(make(pixels.data() + 8, {2, 2}, -4), std::invalid_argument);
    CHECK_THROWS_AS(make(pixels.data(), {2, 2}, 0), std::invalid_argument);
    CHECK_THROWS_AS(make(pixels.data(), {2, 2}, 10), std::invalid_argument);  // breaks the alignment
    CHECK_NOTHROW(make(pixels.data(), {2, 1}, 0));                            // one row has no next one
    constexpr auto least = std::numeric_limits<std::ptrdiff_t>::min(), greatest = -(least + 1);
    for (const std::ptrdiff_t far_rows : {least, least + 4, greatest - 3, greatest / 2 + 1}) {
        CHECK_THROWS_AS(make(pixels.data(), {2, 2}, far_rows), std::invalid_argument);
        CHECK_THROWS_AS(make(pixels.data(), {2, 3}, far_rows), std::invalid_argument);
    }
    const ivec2 many(std::numeric_limits<int>::max());
    CHECK_THROWS_AS((void)image_view<int>(pixels.data(), many), std::invalid_argument);
    CHECK_THROWS_AS((void)image<int>(many), std::length_error);
    CHECK_NOTHROW(make(pixels.data(), {2, 2}, 8));
    CHECK_NOTHROW(make(pixels.data() + 2, {2, 2}, -8));
    CHECK_THROWS_AS((void)image_view<int>(nullptr, ivec2(1, 1)), std::invalid_argument);
    CHECK_THROWS_AS(image<int>({-1, 1}), std::invalid_argument);
    CHECK_THROWS_AS(image<int>({1, -1}), std::invalid_argument);
}

TEST_CASE("image: owns its texels") {
    image<float> map({2, 3}, 0.5f);
    CHECK(map.texels().size() == 6);
    for (float texel : map.texels()) CHECK(texel == 0.5f);
    const image<float> copy = map;
    map[{1, 2}] = 0.25f;
    CHECK(map.view()[{1, 2}] == 0.25f);
    CHECK(copy[{1, 2}] == 0.5f);
    const image<float> moved = std::move(map);
    CHECK(moved[{1, 2}] == 0.25f);
    const image<int> zeros({2, 1});
    CHECK(zeros.texels()[1] == 0);
}

TEST_CASE("image: moved from, it is empty, and may be assigned to") {
    static_assert(std::is_nothrow_move_constructible_v<image<float>> &&
                  std::is_nothrow_move_assignable_v<image<float>>);
    image<float> map({2, 3}, 0.5f), other({4, 4});
    const float* const texels = map.texels().data();
    other = std::move(map);
    CHECK(other.size() == ivec2(2, 3));
    CHECK(other.texels().data() == texels);
    CHECK(map.size() == ivec2(0));
    CHECK(map.view().empty());
    image<float> third = std::move(other);
    CHECK(third.texels().data() == texels);
    CHECK(other.size() == ivec2(0));
    CHECK(other.empty());
    auto& same = third;
    third = std::move(same);
    CHECK(third.view().empty() == third.empty());
    other = image<float>({1, 1}, 0.25f);
    CHECK(other[{0, 0}] == 0.25f);
}

TEST_CASE("fetch_clamped: outside goes to the nearest texel inside") {
    const auto map = counted({3, 2});
    const auto view = map.view();
    for (int y = -2; y < 4; ++y)
        for (int x = -2; x < 5; ++x)
            CHECK(fetch_clamped(view, {x, y}) == 10 * std::min(std::max(y, 0), 1) + std::min(std::max(x, 0), 2));
    constexpr int least = std::numeric_limits<int>::min(), greatest = std::numeric_limits<int>::max();
    CHECK(fetch_clamped(view, {least, greatest}) == 10);
    CHECK(fetch_clamped(view, {greatest, least}) == 2);
    CHECK(clamped(map)({7, 7}) == 12);
    CHECK(clamped(view)({-1, 1}) == 10);
    CHECK_THROWS_AS((void)clamped(image<float>()), std::invalid_argument);
    CHECK_THROWS_AS((void)clamped(image_view<const float>(nullptr, {4, 0})), std::invalid_argument);
}

TEST_CASE("fetch_bordered: outside is the border, and an empty map is all border") {
    const auto map = counted({3, 2});
    for (int y = -2; y < 4; ++y)
        for (int x = -2; x < 5; ++x) {
            const bool inside = x >= 0 && x < 3 && y >= 0 && y < 2;
            CHECK(fetch_bordered(map.view(), {x, y}, -7) == (inside ? 10 * y + x : -7));
        }
    CHECK(bordered(map, -7)({std::numeric_limits<int>::max(), 0}) == -7);
    CHECK(bordered(map.view(), -7)({2, 1}) == 12);
    CHECK(bordered(image<float>({1, 1}), 1)({2, 1}) == 1.0f);
    CHECK(bordered(image<int>(), -7)({0, 0}) == -7);
}

TEST_CASE("texel_inside: a texel of the map is itself, any other becomes one of the map") {
    for (int x = -9; x < 9; ++x)
        for (int y = -9; y < 9; ++y) {
            const glm::ivec2 size(5, 1), at(x, y), inside = texel_inside(size, at);
            CHECK(inside_map(size, inside));
            CHECK((inside == at) == inside_map(size, at));
        }
}

TEST_CASE("bordered: depths without a border are lit outside by default") {
    const image<float> map({2, 1}, 0.25f);
    CHECK(bordered(map)({1, 0}) == 0.25f);
    for (const glm::ivec2 outside : {glm::ivec2(-1, 0), glm::ivec2(2, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        CHECK(bordered(map)(outside) == 1.0f);
        CHECK(bordered(map.view())(outside) == 1.0f);
        CHECK(bordered(image<double>({2, 1}, 0.25))(outside) == 1.0);
    }
}

TEST_CASE("line_allocator: memory starts at a cache line") {
    for (const std::size_t count : {1u, 3u, 63u, 64u, 1000u}) {
        const std::vector<std::uint8_t, detail::line_allocator<std::uint8_t>> bytes(count, 7);
        CHECK(reinterpret_cast<std::uintptr_t>(bytes.data()) % 64 == 0);
        CHECK(bytes.back() == 7);
    }
}
