// SPDX-License-Identifier: MIT
#include <umbrage/shader/hooks/fetch.hpp>

#include <doctest/doctest.h>

#include <umbrage/shader/hook_choice.hpp>

namespace glsl = umbrage::glsl;
using umbrage::glsl::detail::chosen;
using namespace umbrage::glsl;

TEST_CASE("a map's texels choose by direction, by what is outside, and by who compares") {
    const binding ordinary, reversed{.direction = umbrage::depth_direction::reversed},
        clamped{.outside = umbrage::outside_map::clamped}, shadow{.texture = texture::shadow},
        clamped_shadow{.texture = texture::shadow, .outside = umbrage::outside_map::clamped};
    CHECK(&chosen(glsl::compare, ordinary) == &glsl::compare);
    CHECK(&chosen(glsl::compare, reversed) == &hooks::reversed_compare);
    CHECK(&chosen(glsl::fetch_depth, ordinary) == &glsl::fetch_depth);
    CHECK(&chosen(glsl::fetch_depth, clamped) == &hooks::clamped_depth);
    CHECK(&chosen(glsl::texel_inside, ordinary) == &glsl::texel_inside);
    CHECK(&chosen(glsl::texel_inside, clamped_shadow) == &hooks::clamped_texel_inside);
    CHECK(&chosen(glsl::lit, ordinary) == &glsl::lit);
    CHECK(&chosen(glsl::lit, shadow) == &hooks::bordered_lit);
    CHECK(&chosen(glsl::lit, clamped_shadow) == &hooks::clamped_lit);
    const binding planed{.receiver_plane = true}, planed_shadow{.texture = texture::shadow, .receiver_plane = true};
    CHECK(&chosen(glsl::lit, planed) == &hooks::planed_lit);
    CHECK(&chosen(glsl::lit, planed_shadow) == &hooks::planed_compared_lit);
}
