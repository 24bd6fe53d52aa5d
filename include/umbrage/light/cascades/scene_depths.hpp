// SPDX-License-Identifier: MIT
//
// Range of depths that the maps of a directional light need for a scene, equal for all of them. For stable cascades.
//
// The light's axes are X, Y, and Z along its rays. The scene has sides s_i along the axes i of the world. Inside a
// map of sides w and h, its depths have a range of at most (s_i + |X_i| w + |Y_i| h) / |Z_i|. This holds wherever the
// map lies. So a wide ground needs no more depth than a map's part of it. The smallest of these ranges serves all maps.
//
#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>

namespace umbrage {
namespace detail {

/// Depths of a scene along a directional light, as maps see them. Their range is equal for all maps, wherever they lie.
class scene_depths {
public:
    /// @param side   sides of the largest map, world units
    template <real T>
    scene_depths(const bounding_box<T>& scene, const light_space<double>& light, glm::dvec2 side, const char* function)
        : low_(scene.low), high_(scene.high), frame_(light_frame(light.view, light.clip.hand)) {
        const extent box = extent_of(seen(glm::dmat4(frame_), hull(scene).points));
        const glm::dvec2 across = (glm::min)(glm::dvec2(box.high - box.low), side);
        nearest_ = box.low.z;
        double longest = box.high.z - box.low.z;
        for (glm::length_t i = 0; i < 3; ++i) {
            // std::abs, as glm::abs keeps -0
            const double within = (high_[i] - low_[i] + across_of(i, side)) / std::abs(frame_[i].z);
            if (within < longest) longest = within, axis_ = static_cast<int>(i);
        }
        beyond_ = glm::length(glm::dvec3(across, longest)) * 0x1p-8;  // flat scenes need some depth too
        range_ = (longest + 2.0 * beyond_) * (steps / (steps - 1.0));
        require(is_normal(range_) && is_normal(1.0 / range_), function, "low and high of scene",
                "neither too far apart nor too close together", glm::dmat2x3(low_, high_));
    }

    /// Light with these depths in its map. They start a whole number of steps from the world's origin.
    [[nodiscard]] light_space<double> of(light_space<double> light) const {
        const glm::dvec2 half(1.0 / light.projection[0][0], 1.0 / light.projection[1][1]);
        const glm::dvec2 middle = -glm::dvec2(light.projection[3]) * half;
        const double start = std::floor((nearest_to(middle, 2.0 * half) - beyond_) / range_ * steps) / steps;
        const auto [at_near, at_far] = ends<double>(light.clip);
        const double towards = light.clip.hand == handedness::right ? -1.0 : 1.0;
        light.projection[2][2] = towards * (at_far - at_near) / range_;
        light.projection[3][2] = at_near - (at_far - at_near) * start;
        return light;
    }

private:
    static constexpr double steps = 8.0;  ///< a power of two: whole steps keep the bits of depths

    /// Length of a map's sides along an axis of the world.
    [[nodiscard]] double across_of(glm::length_t i, glm::dvec2 side) const {
        return glm::abs(frame_[i].x) * side.x + glm::abs(frame_[i].y) * side.y;
    }
    /// Smallest depth that the scene can have in a map.
    [[nodiscard]] double nearest_to(glm::dvec2 middle, glm::dvec2 side) const {
        if (axis_ < 0) return nearest_;
        const auto number = static_cast<glm::length_t>(axis_);
        const glm::dvec3 axis = frame_[number];
        const double from = (axis.z > 0.0 ? low_ : high_)[number] - axis.x * middle.x - axis.y * middle.y;
        return from / axis.z - across_of(number, side) / (2.0 * std::abs(axis.z));
    }

    glm::dvec3 low_, high_;
    glm::dmat3 frame_;  ///< columns: axes of the world as the light sees them
    int axis_ = -1;     ///< axis of the world whose sides bound the depths; -1: the whole box bounds them
    double nearest_, beyond_, range_;
};

}  // namespace detail
}  // namespace umbrage
