// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include <umbrage/core/parallel.hpp>

TEST_CASE("serial: all in one piece, nothing of nothing") {
    for (const int count : {1, 2, 1000}) {
        std::vector<std::pair<int, int>> pieces;
        umbrage::serial{}(count, [&](int first, int last) { pieces.emplace_back(first, last); });
        CHECK(pieces == std::vector{std::pair{0, count}});
    }
    for (const int count : {0, -1}) umbrage::serial{}(count, [](int, int) { CHECK(false); });
}
