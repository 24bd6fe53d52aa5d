// SPDX-License-Identifier: MIT
#include "camera.hpp"

#include <umbrage/draw/rasterize.hpp>

namespace example {

void draw_depths(umbrage::image_view<float> depths, const umbrage::mesh_view& m, std::span<const glm::mat4> places,
                 const glm::mat4& world_to_clip) {
    umbrage::rasterize_depth(depths, m, places, world_to_clip, picture_clip);
}

umbrage::image<std::uint32_t> camera_pass(const mesh& m, const camera& c, glm::ivec2 size) {
    umbrage::image<float> depth(size, umbrage::cleared_depth(picture_clip));
    umbrage::image<std::uint32_t> seen(size, nothing);
    umbrage::rasterize(size, view_of(m), c.world_to_clip, picture_clip,
                       [&](glm::ivec2 texel, float z, std::uint32_t triangle) {
                           if (z > depth[texel] || (z == depth[texel] && triangle > seen[texel])) return;
                           depth[texel] = z;
                           seen[texel] = triangle;
                       });
    return seen;
}

}  // namespace example
