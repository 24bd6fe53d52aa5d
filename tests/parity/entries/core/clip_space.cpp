// SPDX-License-Identifier: MIT
#include <umbrage/core/clip_space.hpp>

#include "../entries.hpp"

namespace parity {

void add_core_clip_space(std::vector<entry>& all) {
    using namespace umbrage;
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        all.push_back({.primitive = &umbrage::glsl::cleared_depth,
                       .variant = direction == depth_direction::forward ? "" : "reversed",
                       .classes = spread({{0.0f, 1.0f}}, {}),
                       .twin = [direction](const sample& s) { return vec4(cleared_depth(direction), vec3(s.x[0])); },
                       .call = "vec4(umbrage_cleared_depth(), x0.x, x0.y, x0.z)",
                       .map_kind = {.direction = direction}});
}

}  // namespace parity
