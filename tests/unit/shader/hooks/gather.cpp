// SPDX-License-Identifier: MIT
#include <umbrage/shader/hooks/gather.hpp>

#include <doctest/doctest.h>

#include <umbrage/shader/hook_choice.hpp>

namespace glsl = umbrage::glsl;
using umbrage::glsl::detail::chosen;
using namespace umbrage::glsl;
using umbrage::outside_map;

TEST_CASE("four texels at once are gathered where the map says so, and stay inside a region") {
    const binding gathered{.outside = outside_map::clamped, .gather = true}, whole{.gather = true},
        region{.gather = true, .origin = "vec2(8.0, 0.0)"};
    CHECK(&chosen(glsl::lit_2x2, binding{}) == &glsl::lit_2x2);
    CHECK(&chosen(glsl::lit_2x2, gathered) == &hooks::gathered);
    CHECK(&chosen(glsl::lit_2x2, region) == &hooks::gathered_region);
    CHECK(&chosen(glsl::lit_2x2, whole) == &hooks::gathered_bordered);
}
