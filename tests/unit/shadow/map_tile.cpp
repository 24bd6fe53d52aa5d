// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/shadow/map_tile.hpp>

using namespace umbrage;

TEST_CASE("map_tile: rows of two, three and eight maps, as cascades, cubes and pages lie alone") {
    CHECK(map_tile(5, 3, {100, 50}) == glm::ivec2(200, 50));
    for (int n = 0; n < 8; ++n) CHECK(map_tile(n, 2, {64, 32}) == cascade_tile(n, {64, 32}));
    for (int n = 0; n < 6; ++n) CHECK(map_tile(n, 3, glm::ivec2(64)) == cube_tile(n, 64));
    for (int n = 0; n < 64; ++n) CHECK(map_tile(n, 8, glm::ivec2(64)) == page_tile(n, 64));
}
