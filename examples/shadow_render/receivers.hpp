// SPDX-License-Identifier: MIT
//
// Where in the shadow map each sample of the picture looks, and what it compares with, bias and all.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/receivers.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <progress.hpp>

#include "options.hpp"
#include "view.hpp"

namespace shadow_render {

/// Coordinates in texels and depths, biased.
struct receivers {
    umbrage::image<float> x, y, depth;
    umbrage::image<float> slope_x{}, slope_y{};  ///< of stored depths that the bias moves, a texel

    explicit receivers(glm::ivec2 size, glm::vec3 value = umbrage::project_coordinate(glm::vec4(0)))  // lit in any map
        : x(size, value.x), y(size, value.y), depth(size, value.z) {}

    [[nodiscard]] umbrage::receiver_planes planes() const { return {x, y, depth}; }
    [[nodiscard]] umbrage::sloped_receivers sloped() const { return {planes(), slope_x, slope_y}; }
};

/// @param reach       texels that the options' bias covers
/// @param below       how far the encoding may answer below the depth it was given
/// @param projected   depths are z/w instead of growing evenly, as a bias asks for that moves stored ones
[[nodiscard]] receivers receivers_of(const view& v, const options& o, float reach, float below,
                                     example::progress& progress, bool projected = false);

}  // namespace shadow_render
