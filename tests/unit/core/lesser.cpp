// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <glm/vec3.hpp>

#include <umbrage/core/lesser.hpp>

namespace detail = umbrage::detail;

TEST_CASE("lesser: lesser, greater and limited") {
    CHECK(detail::lesser(2, 3) == 2);
    CHECK(detail::greater(2, 3) == 3);
    CHECK(detail::lesser(glm::ivec3(1, 5, 3), glm::ivec3(2, 4, 3)) == glm::ivec3(1, 4, 3));
    CHECK(detail::greater(glm::ivec3(1, 5, 3), glm::ivec3(2, 4, 3)) == glm::ivec3(2, 5, 3));
    CHECK(detail::limited(-1, 0, 5) == 0);
    CHECK(detail::limited(4, 0, 5) == 4);
    CHECK(detail::limited(6, 0, 5) == 5);
    CHECK(detail::lesser(3, 1, 2) == 1);
    CHECK(detail::greater(1, 3, 2) == 3);
}
