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

/// Over pixels that face the light.
struct squared {
    double sum = 0, pixels = 0;  ///< of squared differences of visibility
};
[[nodiscard]] squared squared_error(const by_rays& expected, const umbrage::image<float>& visibility, int samples);

/// Root of the mean square over pixels that face the light, in per cent.
[[nodiscard]] double rms_error(const by_rays& expected, const umbrage::image<float>& visibility, int samples);

/// Over samples that face the light and of which no ray reaches it.
struct leaked {
    double sum = 0, samples = 0;  ///< of visibility
};
[[nodiscard]] leaked leaked_light(const by_rays& expected, const umbrage::image<float>& visibility);

/// Its mean, in per cent.
[[nodiscard]] double leak(const by_rays& expected, const umbrage::image<float>& visibility);

}  // namespace shadow_render
