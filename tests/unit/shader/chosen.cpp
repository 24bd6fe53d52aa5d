// SPDX-License-Identifier: MIT
#include <umbrage/shader/chosen.hpp>

#include <doctest/doctest.h>

#include <umbrage/filter/pcf/hard.hpp>

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

TEST_CASE("outside whole maps and layers all is lit; tiles, regions and faces of cubes clamp; a name says otherwise") {
    using enum texture;
    for (const texture kind : {texture_2d, array, integer, depth, depth_array, shadow, shadow_array}) {
        CHECK(umbrage::glsl::detail::is_bordered({.texture = kind}));
        CHECK_FALSE(umbrage::glsl::detail::is_bordered({.texture = kind, .origin = "vec2(8.0, 0.0)"}));
        CHECK_FALSE(umbrage::glsl::detail::is_bordered({.texture = kind, .outside = outside_map::clamped}));
    }
    for (const texture kind : {atlas, cube, cube_faces}) {
        CHECK_FALSE(umbrage::glsl::detail::is_bordered({.texture = kind}));
        CHECK(umbrage::glsl::detail::is_bordered({.texture = kind, .outside = outside_map::bordered}));
    }
}

TEST_CASE("a snippet is a map's own where it is a hook or calls one, and reads the map where a hook does") {
    using namespace umbrage::glsl::detail;
    CHECK(is_of_map(glsl::hard));
    CHECK(reads_map(glsl::hard));
    CHECK(is_of_map(glsl::beyond_far_plane));
    CHECK_FALSE(reads_map(glsl::in_filter_domain));
    CHECK_FALSE(is_of_map(glsl::inside_texel_space));
}
