// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/simd/min_max.hpp>

namespace detail = umbrage::detail;

TEST_CASE("min_max: lesser, greater and limited") {
    CHECK(detail::lesser(2, 3) == 2);
    CHECK(detail::greater(2, 3) == 3);
    CHECK(detail::limited(-1, 0, 5) == 0);
    CHECK(detail::limited(4, 0, 5) == 4);
    CHECK(detail::limited(6, 0, 5) == 5);
    CHECK(detail::lesser(3, 1, 2) == 1);
    CHECK(detail::greater(1, 3, 2) == 3);
}
