// SPDX-License-Identifier: MIT
#include <umbrage/shader/hooks/sample.hpp>

#include <doctest/doctest.h>

#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>
#include <umbrage/shader/hook_choice.hpp>

namespace glsl = umbrage::glsl;
using umbrage::glsl::detail::chosen;
using namespace umbrage::glsl;
using umbrage::outside_map;

TEST_CASE("a sampler reads between texels where the map lets it: by its comparison, its gathers, and what is outside") {
    const binding gathered{.outside = outside_map::clamped, .gather = true}, whole{.gather = true},
        shadow{.texture = texture::shadow}, clamped_shadow{.texture = texture::shadow, .outside = outside_map::clamped},
        region{.texture = texture::shadow, .origin = "vec2(8.0, 0.0)"},
        along_plane{.texture = texture::shadow, .receiver_plane = true};
    CHECK(&chosen(glsl::lit_filtered, binding{}) == &glsl::lit_filtered);
    CHECK(&chosen(glsl::lit_filtered, shadow) == &hooks::bordered_lit_filtered);
    CHECK(&chosen(glsl::lit_filtered, clamped_shadow) == &hooks::clamped_lit_filtered);
    CHECK(&chosen(glsl::lit_between, binding{}) == &glsl::lit_between);
    CHECK(&chosen(glsl::lit_between, region) == &glsl::lit_between);
    CHECK(&chosen(glsl::lit_between, shadow) == &hooks::sampled_lit);
    CHECK(&chosen(glsl::lit_between, clamped_shadow) == &hooks::sampled_lit);
    CHECK(&chosen(glsl::lit_between, along_plane) == &hooks::planed_lit_between);
    CHECK(&chosen(glsl::covered, binding{}) == &glsl::covered);
    CHECK(&chosen(glsl::covered, region) == &glsl::covered);
    CHECK(&chosen(glsl::covered, shadow) == &hooks::bordered_covered);
    CHECK(&chosen(glsl::covered, along_plane) == &hooks::bordered_covered);
    CHECK(&chosen(glsl::covered, clamped_shadow) == &glsl::covered);
    CHECK(&chosen(glsl::depth_at, binding{}) == &glsl::depth_at);
    CHECK(&chosen(glsl::depth_at, whole) == &hooks::sampled_bordered_depth);
    CHECK(&chosen(glsl::depth_at, gathered) == &hooks::sampled_depth);
}
