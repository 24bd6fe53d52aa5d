// SPDX-License-Identifier: MIT
#include "map_overlay.hpp"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <umbrage/debug/overlay.hpp>
#include <umbrage/draw/dual_paraboloid_pass.hpp>
#include <umbrage/draw/tessellate.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace example {
namespace {

/// Paraboloids draw(i, map) of a lamp that reaches all of a scene, whose mesh is cut for maps of so many texels.
auto paraboloids(const lit_view& v, int side) {
    const glm::vec3 position(v.light.position);
    const float range = glm::length(glm::max(glm::abs(v.scene.low - position), glm::abs(v.scene.high - position)));
    return [light = umbrage::make_dual_paraboloid_light<float>(
                {.position = position, .range = range, .map_size = side, .border = 0, .clip = picture_clip}),
            mesh = umbrage::tessellate(
                view_of(v.scene.geometry),
                {.position = position, .angle = umbrage::paraboloid_edge_angle<float>(side, 0), .range = range})](
               int i, umbrage::image<float>& map) {
        umbrage::rasterize_dual_paraboloid(map.view(), mesh.view(), light, i);
    };
}

}  // namespace

void overlay_maps(umbrage::image_view<glm::u8vec3> picture, const lit_view& v, const placed_maps& maps) {
    const bool have_matrices = !maps.all.empty();
    const int count = have_matrices ? static_cast<int>(maps.all.size()) : maps.count;
    const int side = std::min(picture.size.y / 4, picture.size.x / std::max(count, 6)) - 2;
    if (side < (have_matrices ? 1 : 16)) return;
    const auto overlay = [&](const auto& draw) {
        for (int i = 0; i < count; ++i) {
            umbrage::image<float> depths(glm::ivec2(side), umbrage::cleared_depth(picture_clip));
            draw(i, depths);
            const int left = i * (side + 2);
            const umbrage::image_view<glm::u8vec3> corner{
                picture.data + left, {picture.size.x - left, picture.size.y}, picture.stride};
            umbrage::overlay(corner, depths, {.map_origin = picture_clip.origin}, umbrage::stretch(depths));
        }
    };
    if (!have_matrices) return overlay(paraboloids(v, side));
    const glm::dmat4 to_clip =
        glm::inverse(umbrage::texture_matrix<double>({.clip = umbrage::cpu_clip_space}, maps.size));
    overlay([&](int i, umbrage::image<float>& depths) {
        draw_depths(depths, view_of(v.scene.geometry), once,
                    glm::mat4(to_clip * maps.all[static_cast<std::size_t>(i)]));
    });
}

}  // namespace example
