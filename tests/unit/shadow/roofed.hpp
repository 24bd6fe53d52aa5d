// SPDX-License-Identifier: MIT
//
// A roof above a floor, and how wide the penumbra of its edge is.
#pragma once

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>

namespace shadow_roof {

using namespace umbrage;

/// A floor, and a roof over the half of it where x is below 0, or y. A light at the origin looks down -z at them.
struct roofed {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};

    roofed(const glm::dmat4& to_world, float ground, float roof, bool along_x) {
        const float far = 3;
        const std::array<glm::vec3, 8> all{{{-far, -far, ground},
                                            {far, -far, ground},
                                            {far, far, ground},
                                            {-far, far, ground},
                                            {-far, -far, roof},
                                            {along_x ? 0.0f : far, -far, roof},
                                            {along_x ? 0.0f : far, along_x ? far : 0.0f, roof},
                                            {-far, along_x ? far : 0.0f, roof}}};
        for (const glm::vec3 p : all) positions.emplace_back(to_world * glm::dvec4(p, 1));
    }
};

/// From where a tenth of the light is seen to where nine tenths are, along a way.
template <class Shadow>
[[nodiscard]] float width_along(const Shadow& s, const image<float>& map, glm::vec3 from, glm::vec3 way,
                                glm::vec3 normal, float exact) {
    const auto first = [&](float share) {
        float x = -2 * exact;
        for (; x < 2 * exact; x += exact / 64) {
            float sum = 0;
            for (int i = 0; i < 16; ++i) sum += s(map, from + way * x, normal, {i % 4, i / 4});
            if (sum / 16 >= share) break;
        }
        return x;
    };
    return first(0.9f) - first(0.1f);
}

}  // namespace shadow_roof
