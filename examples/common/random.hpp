// SPDX-License-Identifier: MIT
//
// Random numbers that are hashes of places: the same on every machine, in any order.
//
//     const float turn = example::random_of({row, column}, 3);  // the third number of this place
//
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace example {

/// 0 to 1, of two integers.
[[nodiscard]] inline float random_of(glm::ivec2 at, std::uint32_t which) {
    std::uint32_t h = static_cast<std::uint32_t>(at.x) * 0x9e3779b1u + static_cast<std::uint32_t>(at.y) * 0x85ebca77u +
                      which * 0xc2b2ae3du;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return static_cast<float>((h ^ (h >> 15)) >> 8) * 0x1p-24f;
}

}  // namespace example
