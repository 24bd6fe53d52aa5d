// SPDX-License-Identifier: MIT
#include <umbrage/bias/light_units.hpp>

#include "limits.hpp"

namespace parity {

void add_bias_light_units(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    auto amounts = spread({{0.0f, 9.0f}, {0.0f, 0.1f}, {0.0f, 2.0f}, {0.1f, 99.0f}}, special_values());
    amounts.push_back(
        {"limits", [](std::uint64_t i, random&, sample& s) { s.x[0] = vec4(limit(i), 1.0f, 1.0f, 1.0f); }});
    all.push_back(
        {.primitive = &glsl::texels_to_world,
         .classes = amounts,
         .twin = [](const sample& s) { return vec4(texels_to_world(s.x[0].x, vec2(s.x[0].y, s.x[0].z), s.x[0].w)); },
         .call = "vec4(umbrage_texels_to_world(x0.x, vec2(x0.y, x0.z), x0.w))"});
    all.push_back(
        {.primitive = &glsl::world_to_depth,
         .classes = amounts,
         .twin = [](const sample& s) { return vec4(world_to_depth(s.x[0].x, vec2(s.x[0].y, s.x[0].z), s.x[0].w)); },
         .call = "vec4(umbrage_world_to_depth(x0.x, vec2(x0.y, x0.z), x0.w))"});
}

}  // namespace parity
