// SPDX-License-Identifier: MIT
#include <umbrage/shader/texel_hooks.hpp>

#include <doctest/doctest.h>

#include <umbrage/shader/compose.hpp>

namespace glsl = umbrage::glsl;
using umbrage::glsl::detail::chosen;
using namespace umbrage::glsl;

TEST_CASE("a map's texels choose by direction, by what is outside, and by who compares") {
    const binding ordinary, reversed{.direction = umbrage::depth_direction::reversed}, lit_outside{.outside_lit = true},
        shadow{.texture = texture::shadow}, lit_shadow{.texture = texture::shadow, .outside_lit = true};
    CHECK(&chosen(glsl::compare, ordinary) == &hooks::forward_compare);
    CHECK(&chosen(glsl::compare, reversed) == &hooks::reversed_compare);
    CHECK(&chosen(glsl::fetch_depth, ordinary) == &hooks::clamped_depth);
    CHECK(&chosen(glsl::fetch_depth, lit_outside) == &hooks::bordered_depth);
    CHECK(&chosen(glsl::lit, ordinary) == &glsl::lit);
    CHECK(&chosen(glsl::lit, shadow) == &hooks::clamped_lit);
    CHECK(&chosen(glsl::lit, lit_shadow) == &hooks::bordered_lit);
}

TEST_CASE("four texels at once are gathered where the map says so, and stay inside a region") {
    const binding gathered{.gather = true}, region{.gather = true, .origin = "vec2(8.0, 0.0)"},
        lit_outside{.outside_lit = true, .gather = true};
    CHECK(&chosen(glsl::lit_2x2, binding{}) == &glsl::lit_2x2);
    CHECK(&chosen(glsl::lit_2x2, gathered) == &hooks::gathered);
    CHECK(&chosen(glsl::lit_2x2, region) == &hooks::gathered_region);
    CHECK(&chosen(glsl::lit_2x2, lit_outside) == &hooks::gathered_bordered);
}
