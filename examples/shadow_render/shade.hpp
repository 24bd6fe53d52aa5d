// SPDX-License-Identifier: MIT
//
// The picture: diffuse and ambient light on what the camera sees.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>

#include <srgb.hpp>

#include "view.hpp"

namespace shadow_render {

inline constexpr float ambient = 0.22f;
inline constexpr glm::vec3 background{0.30f, 0.36f, 0.44f};

/// Mean of the samples of a pixel.
/// @param sample  place in a row of samples, row -> value
template <class T, class Sample>
[[nodiscard]] T mean(int pixel, int samples, Sample&& sample) {
    T sum(0);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) sum += sample(pixel * samples + x, y);
    return sum / static_cast<float>(samples * samples);
}

/// A row of samples: linear light.
void shade_row(const view& v, const umbrage::image<float>& visibility, int y, glm::vec3* out);

/// Diffuse plus ambient light, inside the cone.
/// @param parallel  as the library's functions take it
template <class ParallelFor>
[[nodiscard]] umbrage::image<glm::u8vec3> shade(const view& v, const umbrage::image<float>& visibility, int samples,
                                                ParallelFor&& parallel) {
    umbrage::image<glm::u8vec3> pixels(v.seen.size() / samples);
    parallel(pixels.size().y, [&](int first, int last) {
        const std::size_t width = static_cast<std::size_t>(v.seen.size().x);
        std::vector<glm::vec3> light(width * static_cast<std::size_t>(samples));
        for (int y = first; y < last; ++y) {
            for (int row = 0; row < samples; ++row)
                shade_row(v, visibility, y * samples + row, &light[static_cast<std::size_t>(row) * width]);
            for (int x = 0; x < pixels.size().x; ++x)
                pixels[{x, y}] = example::to_srgb(mean<glm::vec3>(x, samples, [&](int at, int row) {
                    return light[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(at)];
                }));
        }
    });
    return pixels;
}

}  // namespace shadow_render
