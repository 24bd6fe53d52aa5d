// SPDX-License-Identifier: MIT
#include "map_overlay.hpp"

#include <algorithm>

#include <glm/matrix.hpp>

#include <umbrage/images/overlay.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace example {

void overlay_maps(umbrage::image_view<glm::u8vec3> picture, const lit_view& v, const placed_maps& maps) {
    const int count = static_cast<int>(maps.all.size());
    const int side = std::min(picture.size.y / 4, picture.size.x / std::max(count, 6)) - 2;
    if (side < 1) return;
    const glm::dmat4 to_clip = glm::inverse(umbrage::texture_matrix<double>({}, maps.size));
    for (int i = 0; i < count; ++i) {
        umbrage::image<float> depths(glm::ivec2(side), umbrage::cleared_depth(picture_clip));
        draw_depths(depths, view_of(v.scene.geometry), once,
                    glm::mat4(to_clip * maps.all[static_cast<std::size_t>(i)]));
        const int left = i * (side + 2);
        const umbrage::image_view<glm::u8vec3> corner{
            picture.data + left, {picture.size.x - left, picture.size.y}, picture.stride};
        umbrage::overlay(corner, depths, {.map_origin = picture_clip.origin}, umbrage::stretch(depths));
    }
}

}  // namespace example
