// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include <umbrage/images/raster/row_locks.hpp>

using namespace umbrage;

TEST_CASE("row_locks: what two threads do to the same rows is done one after the other") {
    constexpr int height = 100, rounds = 20000;
    std::vector<int> counts(height, 0);  // not atomic
    detail::row_locks<> locks(height);
    const auto count_all = [&](bool upwards) {
        for (int i = 0; i < rounds; ++i) {
            const int first = (upwards ? i : rounds - 1 - i) % 50;
            locks.hold({first, height - first}, [&] {
                for (int y = first; y < height - first; ++y) ++counts[std::size_t(y)];
            });
        }
    };
    {
        std::jthread other(count_all, true);
        count_all(false);
    }
    for (int y = 0; y < height; ++y)
        CHECK(counts[std::size_t(y)] == 2 * rounds / 50 * (std::min(y, height - 1 - y) + 1));
    int last_row = 0;
    locks.hold({height - 1, height}, [&] { ++last_row; });
    CHECK(last_row == 1);
}
