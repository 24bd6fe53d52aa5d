// SPDX-License-Identifier: MIT
//
// Oracle of discs between texels: their points, and the four texels around each, in real numbers.
#pragma once

#include <cmath>
#include <cstdint>

#include <umbrage/filter/pcf/disc.hpp>

#include "maps.hpp"

namespace in_reals {

/// Calls use(where a point lies, in texels) for each of an ellipse's points.
template <int Points, class Use>
void for_each_point(glm::dvec2 coord, glm::dvec4 rotation, glm::dvec2 radius, const Use& use) {
    for (const glm::ivec2 p : umbrage::disc_points<Points>)
        use(coord +
            glm::dvec2(rotation.x * p.x + rotation.y * p.y, rotation.z * p.x + rotation.w * p.y) * radius / 1024.0);
}

/// Lit share of the four texels around each point, weighed.
template <int Points>
double lit_share(const umbrage::image<float>& map, glm::dvec2 coord, double receiver, glm::dvec2 radius,
                 glm::dvec4 rotation) {
    double sum = 0;
    for_each_point<Points>(coord, rotation, radius, [&](glm::dvec2 at) {
        const glm::dvec2 first = glm::floor(at - 0.5), weight = at - 0.5 - first;
        for (int j : {0, 1})
            for (int i : {0, 1}) {
                const double stored = double(texel_at(map, std::int64_t(first.x) + i, std::int64_t(first.y) + j));
                const double share = (i ? weight.x : 1 - weight.x) * (j ? weight.y : 1 - weight.y);
                sum += receiver <= stored ? share : 0.0;
            }
    });
    return sum / Points;
}

}  // namespace in_reals
