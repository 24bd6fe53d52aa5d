// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/hard.hpp>

namespace {

/// A user's own: all that functions over images ask for.
struct mine {
    float operator()(auto&& fetch, glm::vec2 coord, float receiver) const {
        return receiver <= fetch(glm::ivec2(coord)) ? 1.0f : 0.0f;
    }
};

struct takes_no_fetch {
    float operator()(glm::vec2, float) const { return 1.0f; }
};

struct changes_itself {
    float operator()(auto&&, glm::vec2, float) { return 1.0f; }
};

}  // namespace

TEST_CASE("filter: a callable of map, coordinate and receiver; what it tells of itself makes it known") {
    static_assert(umbrage::filter<mine> && !umbrage::known_filter<mine>);
    static_assert(umbrage::known_filter<umbrage::filters::hard> && umbrage::known_filter<umbrage::filters::box>);
    static_assert(!umbrage::filter<takes_no_fetch> && !umbrage::filter<changes_itself> && !umbrage::filter<float>);
    static_assert(umbrage::detail::is_filter<mine>());
    const float lit = 1.0f;
    const auto captures = [&](auto&&, glm::vec2, float) { return lit; };
    static_assert(umbrage::filter<decltype(captures)>);
    CHECK(mine{}([](glm::ivec2) { return 0.5f; }, glm::vec2(0.5f), 0.5f) == 1.0f);
}
