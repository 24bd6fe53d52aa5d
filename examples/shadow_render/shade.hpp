// SPDX-License-Identifier: MIT
//
// The picture: direct light and that of the sky on what the camera sees.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>

#include <srgb.hpp>

#include "view.hpp"

namespace shadow_render {

/// The sky by height in the picture: 0 at its top, 1 at its foot.
[[nodiscard]] inline glm::vec3 sky(float down) {
    return glm::mix(glm::vec3(0.13f, 0.28f, 0.52f), glm::vec3(1.20f, 1.10f, 0.95f), down);
}

/// Tones below a half as they are; above, ever closer to 1, so that nothing clips to white.
[[nodiscard]] inline float shoulder(float tone) {
    const float over = tone + tone - 1;
    return tone > 0.5f ? 0.5f + 0.5f * over / (1 + over) : tone;
}

/// Linear light that a surface sends to the eye: of a warm light, and of a hemisphere, blue above and brown below.
/// @param n_dot_l  cosine between normal and direction to the light
[[nodiscard]] inline glm::vec3 shaded(glm::vec3 color, glm::vec3 normal, float n_dot_l, float visibility) {
    constexpr glm::vec3 light{1.75f, 1.60f, 1.38f}, above{0.36f, 0.44f, 0.58f}, below{0.24f, 0.21f, 0.18f};
    const float lit = n_dot_l > 0 ? n_dot_l * visibility : 0.0f, up = 0.5f + 0.5f * normal.y;
    const glm::vec3 sum = color * (lit * light + glm::mix(below, above, up));
    return {shoulder(sum.r), shoulder(sum.g), shoulder(sum.b)};
}

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

/// The picture under shadows, inside the cone.
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
