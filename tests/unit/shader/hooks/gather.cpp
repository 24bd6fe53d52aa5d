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
        region{.gather = true, .origin = "vec2(8.0, 0.0)"}, compared{.texture = texture::shadow, .gather = true},
        planed{.gather = true, .receiver_plane = true};
    CHECK(&chosen(glsl::lit_2x2, binding{}) == &glsl::lit_2x2);
    CHECK(&chosen(glsl::lit_2x2, gathered) == &hooks::gathered);
    CHECK(&chosen(glsl::lit_2x2, region) == &hooks::gathered);
    CHECK(&chosen(glsl::lit_2x2, whole) == &hooks::gathered_bordered);
    CHECK(&chosen(glsl::lit_2x2, planed) == &hooks::gathered);  // the border is in the plane's reference
    CHECK(&chosen(hooks::gather_clamped, whole) == &hooks::gather_clamped);
    CHECK(&chosen(hooks::gather_clamped, region) == &hooks::gather_in_region);
    CHECK(&chosen(hooks::gather_lit, whole) == &hooks::gathered_lit);
    CHECK(&chosen(hooks::gather_lit, compared) == &hooks::gather_lit);
    CHECK(&chosen(hooks::gather_lit, planed) == &hooks::planed_gathered_lit);
    CHECK(&chosen(hooks::gather_compared, compared) == &hooks::gather_compared);
    CHECK(&chosen(hooks::gather_compared, whole) == &hooks::gather_one_channel);
}
