// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <umbrage/core/algorithm.hpp>

namespace detail = umbrage::detail;

TEST_CASE("algorithm: lesser, greater, limited, copy and fill") {
    CHECK(detail::lesser(2, 3) == 2);
    CHECK(detail::greater(2, 3) == 3);
    CHECK(detail::lesser(glm::ivec3(1, 5, 3), glm::ivec3(2, 4, 3)) == glm::ivec3(1, 4, 3));
    CHECK(detail::greater(glm::ivec3(1, 5, 3), glm::ivec3(2, 4, 3)) == glm::ivec3(2, 5, 3));
    CHECK(detail::limited(-1, 0, 5) == 0);
    CHECK(detail::limited(4, 0, 5) == 4);
    CHECK(detail::limited(6, 0, 5) == 5);
    int from[3]{1, 2, 3}, to[4]{};
    detail::copy(from, 2, to + 1);
    detail::fill(to + 3, 1, 7);
    CHECK((to[0] == 0 && to[1] == 1 && to[2] == 2 && to[3] == 7));
}

TEST_CASE("algorithm: sort, count_in_front and ranked do what the standard's do, for numbers of which many are equal") {
    std::mt19937 random(1);
    for (std::size_t size = 0; size < 200; ++size) {
        std::vector<int> numbers(size);
        for (int& n : numbers) n = static_cast<int>(random() % (size / 2 + 1));
        std::vector<int> sorted = numbers;
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t rank = 0; rank < size; ++rank) {
            std::vector<int> shuffled = numbers;
            CHECK(detail::ranked(shuffled, rank) == sorted[rank]);
        }
        const auto below = [&](int n) { return n < static_cast<int>(size / 4); };
        CHECK(detail::count_in_front(sorted, below) == std::size_t(std::count_if(sorted.begin(), sorted.end(), below)));

        std::vector<std::pair<int, std::size_t>> pairs;
        for (std::size_t i = 0; i < size; ++i) pairs.emplace_back(numbers[i], i);
        detail::sort(pairs, [](const auto& a, const auto& b) { return a.first < b.first; });
        CHECK(std::is_sorted(pairs.begin(), pairs.end()));  // of equal ones the earlier first
    }
}
