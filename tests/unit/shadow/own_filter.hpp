// SPDX-License-Identifier: MIT
//
// A filter of a user's own, whose numbers have names and types that no filter of the library has.
#pragma once

#include <string_view>
#include <tuple>

#include <umbrage/core/snippet.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>

namespace own {

namespace glsl = umbrage::glsl;

inline constexpr glsl::snippet two_taps_text{.name = "two_taps",
                                             .summary = "the receiver's texel and one aside",
                                             .exactness = glsl::tier::a,
                                             .needs = glsl::list<&glsl::in_filter_domain, &glsl::lit>,
                                             .source = R"GLSL(
// umbrage_two_taps: visibility of the receiver's texel and of one some steps aside
UMBRAGE_HIGHP float umbrage_two_taps(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                     UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float sharpness,
                                     UMBRAGE_HIGHP vec2 aside, int steps) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 texel = compared ? floor(coord) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float own = umbrage_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float other = umbrage_lit(map, size, texel + aside * float(steps), receiver);
    return compared ? own * sharpness + other * (1.0 - sharpness) : 1.0;
}
)GLSL"};

struct two_taps {
    static constexpr std::string_view name = "two_taps";
    static constexpr const glsl::snippet* snippet = &two_taps_text;

    float sharpness = 0.75f;
    glm::vec2 aside{1, -2};
    int steps = 2;
    umbrage::depth_direction direction = umbrage::depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.sharpness, f.aside, f.steps); }
    [[nodiscard]] float reach() const { return 4.5f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        if (!umbrage::in_filter_domain(coord, receiver, umbrage::comparison{direction})) return 1.0f;
        const glm::ivec2 texel(glm::floor(coord)), far_texel = texel + glm::ivec2(aside) * steps;
        return umbrage::lit(fetch, texel, receiver, umbrage::comparison{direction}) * sharpness +
               umbrage::lit(fetch, far_texel, receiver, umbrage::comparison{direction}) * (1.0f - sharpness);
    }
};

}  // namespace own
