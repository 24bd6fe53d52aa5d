// SPDX-License-Identifier: MIT
//
// The oracle is the texels that a square covers, looked at one by one.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include <umbrage/core/scalar.hpp>
#include <umbrage/images/min_max.hpp>

#include "isas.hpp"

namespace {

struct last_row_first {
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        for (int i = count - 1; i >= 0; --i) piece(i, i + 1);
    }
};

}  // namespace

TEST_CASE("make_min_max_pyramid: bounds of every square, any size of map") {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    std::mt19937 engine(3);
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(2, 7), glm::ivec2(127, 5), glm::ivec2(128, 4), glm::ivec2(301, 66)}) {
        umbrage::image<float> map(size);
        for (float& d : map.texels()) {
            const float odd[] = {nan, -nan, inf, -inf, -1.5f};
            d = engine() % 9 == 0 ? odd[engine() % 5] : static_cast<float>(engine() % 4096) / 4096.0f + 0.25f;
        }
        for_each_isa([&] {
            const auto pyramid = umbrage::make_min_max_pyramid(std::as_const(map).view(), 4, last_row_first{});
            REQUIRE(pyramid.size() == 4);
            for (std::size_t level = 0; level < 4; ++level) {
                const int side = 2 << level;
                const glm::ivec2 squares = (size + (side - 1)) / side;
                REQUIRE(pyramid[level].least.size() == squares);
                REQUIRE(pyramid[level].greatest.size() == squares);
                int wrong = 0;
                for (int y = 0; y < squares.y; ++y)
                    for (int x = 0; x < squares.x; ++x) {
                        float least = inf, greatest = -inf;
                        int numbers = 0, others = 0;
                        for (int j = y * side; j < size.y && j < (y + 1) * side; ++j)
                            for (int i = x * side; i < size.x && i < (x + 1) * side; ++i) {
                                const float d = map[{i, j}];
                                umbrage::is_nan(d) ? ++others : ++numbers;
                                if (d < least) least = d;
                                if (d > greatest) greatest = d;
                            }
                        const float low = pyramid[level].least[{x, y}], high = pyramid[level].greatest[{x, y}];
                        wrong += others ? !umbrage::is_nan(low) : low != least;
                        wrong += numbers ? high != greatest : !umbrage::is_nan(high);
                    }
                CHECK(wrong == 0);
            }
        });
    }
}

TEST_CASE("make_min_max_pyramid: bad input") {
    CHECK_THROWS_AS((void)umbrage::make_min_max_pyramid({}, 1), std::invalid_argument);
    const umbrage::image<float> map({2, 2});
    CHECK_THROWS_AS((void)umbrage::make_min_max_pyramid(map.view(), -1), std::invalid_argument);
    CHECK(umbrage::make_min_max_pyramid(map.view(), 0).empty());
}
