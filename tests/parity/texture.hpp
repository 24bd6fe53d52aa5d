// SPDX-License-Identifier: MIT
//
// Textures that a shader reads, for every back end: inputs, maps as they are bound, and the table.
#pragma once

#include "backend.hpp"

namespace parity {

/// Pixels in a row of what is drawn, and so of the inputs' textures.
inline constexpr int width = 1024;

[[nodiscard]] inline int rows(std::size_t count) { return static_cast<int>((count + width - 1) / width); }

/// One texture without mipmaps, clamped to its edges.
struct texture_image {
    enum shapes { flat, array, cube };
    /// RGBA32F, RGBA32UI, DEPTH_COMPONENT32F, DEPTH_COMPONENT16, RGBA8
    enum formats { floats, whole_numbers, depths, short_depths, bytes };
    enum comparisons { none, less_equal, greater_equal };

    shapes shape = flat;
    formats format = floats;
    comparisons compare = none;  ///< comparison of its sampler
    bool linear = false;         ///< its sampler's filter; else the nearest texel
    ivec2 size{0, 0};
    int layers = 1;
    [[nodiscard]] bool has_depths() const { return format == depths || format == short_depths; }
    bool operator==(const texture_image&) const = default;
};

/// It, the sampler that reads it, and its texels, layer by layer.
struct filled_texture {
    std::size_t unit = 0;
    texture_image image{};
    std::vector<vec4> texels{};
    int unorm_bits = 0;  ///< bits of the UNORM format that it stands for: 8 if every value is k / 255

    /// As the format has them: four floats, four integers, one float, one short, four bytes a texel.
    [[nodiscard]] std::string bytes() const;
};

/// All textures that a job's shader reads.
[[nodiscard]] std::vector<filled_texture> textures(const job& j);

}  // namespace parity
