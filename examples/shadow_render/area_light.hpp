// SPDX-License-Identifier: MIT
//
// The shadow that an area light throws, by rays: what filters are measured against.
#pragma once

#include <cstdint>

#include <umbrage/core/image.hpp>

#include <progress.hpp>

#include "options.hpp"
#include "view.hpp"

namespace shadow_render {

struct by_rays {
    umbrage::image<float> visibility;      ///< of each sample; 1 where the camera sees nothing
    umbrage::image<std::uint8_t> counted;  ///< 1 where a surface faces the light, else it is dark anyway
};

/// A disc of the options' size, across the light's axis; a directional light's stands at the options' distance.
[[nodiscard]] by_rays traced(const options& o, const view& v, example::progress& progress);

inline constexpr int rays_a_sample = 64;

}  // namespace shadow_render
