// SPDX-License-Identifier: MIT
#include <umbrage/light/point/cube_atlas.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// A texel of an atlas in x0.xy, the size of its tiles in x0.w; often at a tile's border.
void atlas_texels(std::uint64_t, random& r, sample& s) {
    const std::uint32_t size = r.below(2) == 0 ? 1u + r.below(8) : 1u << r.below(15);
    for (int axis = 0; axis < 2; ++axis) {
        const std::uint32_t tile = r.below(axis == 0 ? 3 : 2), edge = r.below(4);
        const std::uint32_t within = edge == 0 ? 0 : edge == 1 ? size - 1 : r.below(size);
        s.x[0][axis] = static_cast<float>(tile * size + within);
    }
    s.x[0].w = static_cast<float>(size);
}

}  // namespace

void add_light_point_cube_atlas(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back({.primitive = &glsl::cube_atlas_texel,
                   .classes = {{"texels", atlas_texels}},
                   .twin = [](const sample& s) { return vec4(cube_atlas_texel(vec2(s.x[0]), s.x[0].w), 1.0f); },
                   .call = "vec4(umbrage_cube_atlas_texel(vec2(x0.x, x0.y), x0.w), 1.0)"});
    all.push_back({.primitive = &glsl::cube_atlas_direction,
                   .classes = {{"texels", atlas_texels}},
                   .twin = [](const sample& s) { return vec4(cube_atlas_direction(vec2(s.x[0]), s.x[0].w), 1.0f); },
                   .call = "vec4(umbrage_cube_atlas_direction(vec2(x0.x, x0.y), x0.w), 1.0)"});
}

}  // namespace parity
