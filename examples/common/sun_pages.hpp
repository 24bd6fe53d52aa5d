// SPDX-License-Identifier: MIT
//
// A root around a scene for pages of a sun's map, and what a camera wants of them.
//
//     const auto root = example::page_root_around(low, high, direction, up);
//     example::page_wishes wishes(root, direction, 128, to_pixels);
//     wishes.add(position, normal);  // of surfaces that the camera sees
//     cache.update(wishes.all());
//
#pragma once

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/pixels_per_texel.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace example {

[[nodiscard]] inline umbrage::light_space<double> page_root_around(glm::dvec3 low, glm::dvec3 high,
                                                                   glm::dvec3 direction, glm::dvec3 up,
                                                                   umbrage::clip_space clip = umbrage::cpu_clip_space) {
    return umbrage::make_page_root<double>({.direction = direction,
                                            .up = up,
                                            .center = (low + high) / 2.0,
                                            .side = 1.01 * glm::distance(low, high),
                                            .scene = {low, high},
                                            .clip = clip});
}

class page_wishes {
public:
    /// @param texels      texels of a page, without its gutter
    /// @param to_pixels   world to the camera's picture
    page_wishes(const umbrage::light_space<double>& root, glm::dvec3 direction, int texels, const glm::dmat4& to_pixels)
        : to_root_(umbrage::page_matrix(root)),
          coarsest_(umbrage::texture_matrix(root, glm::ivec2(texels))),
          to_pixels_(to_pixels),
          towards_light_(-glm::normalize(direction)) {}

    /// Surfaces that the light grazes are hardly lit, and would take all: beyond a quarter of its strength they want no
    /// more.
    /// @param normal   on the camera's side, of length one
    void add(glm::dvec3 position, glm::dvec3 normal) {
        const double facing = glm::dot(normal, towards_light_);
        if (!(facing > 0)) return;
        const double extent = std::min(1.0, 4 * facing) * umbrage::longest_extent(umbrage::pixels_per_texel(
                                                              coarsest_, to_pixels_, position, normal));
        all_.push_back({glm::vec2(umbrage::shadow_coordinate(to_root_, position)), static_cast<float>(extent)});
    }

    [[nodiscard]] const std::vector<umbrage::page_receiver>& all() const { return all_; }

private:
    glm::dmat4 to_root_, coarsest_, to_pixels_;
    glm::dvec3 towards_light_;
    std::vector<umbrage::page_receiver> all_;
};

}  // namespace example
