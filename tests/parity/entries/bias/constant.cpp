// SPDX-License-Identifier: MIT
#include <umbrage/bias/constant.hpp>

#include "limits.hpp"

namespace parity {

void add_bias_constant(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back({.primitive = &glsl::clamp_bias,
                   .classes = spread({{-0.5f, 1.5f}}, values_and_limits()),
                   .twin = [](const sample& s) { return vec4(clamp_bias(s.x[0].x)); },
                   .call = "vec4(umbrage_clamp_bias(x0.x))"});
    const auto receivers = spread({{0.0f, 1.0f}, {-0.1f, 0.1f}}, values_and_limits());
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        all.push_back({.primitive = &glsl::biased,
                       .variant = direction == depth_direction::forward ? "" : "reversed",
                       .classes = receivers,
                       .twin = [direction](const sample& s) { return vec4(biased(s.x[0].x, s.x[0].y, direction)); },
                       .call = "vec4(umbrage_biased(x0.x, x0.y))",
                       .map_kind = {.direction = direction}});
}

}  // namespace parity
