// SPDX-License-Identifier: MIT
//
// The solids on a floor of shadow_render --scene solids, as its light and its camera see them.
//
//     const bench::shadowed_scene scene = bench::solids_scene(8);
//
#pragma once

#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>

namespace bench {

struct shadowed_scene {
    umbrage::image<float> map;            ///< bench::map_size
    umbrage::image<glm::vec3> receivers;  ///< bench::screen; where nothing is seen, lit in any map
};

/// @param radius   of the box that the receivers are biased for
[[nodiscard]] shadowed_scene solids_scene(int radius);

}  // namespace bench
