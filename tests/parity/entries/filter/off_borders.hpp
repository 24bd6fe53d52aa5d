// SPDX-License-Identifier: MIT
//
// Positions that a sampler of the nearest texel looks up as C++ does.
#pragma once

#include <algorithm>

#include <umbrage/core/texel_space.hpp>

#include "../entries.hpp"

namespace parity {

/// True when a position is more than a rounding away from borders between texels. There samplers may take either.
[[nodiscard]] inline bool off_borders(vec2 position) {
    const vec2 within = position - glm::floor(position);
    return std::min(std::min(within.x, within.y), 1.0f - std::max(within.x, within.y)) > 1.0f / 512.0f;
}

/// Inputs with a coordinate near the map that `accepted` accepts.
template <class Accepted>
[[nodiscard]] std::vector<input_class> receivers_with(Accepted accepted) {
    std::vector<input_class> all = receivers();
    for (input_class& c : all)
        c.fill = [fill = c.fill, accepted](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            if (!umbrage::inside_texel_space(at(s))) return;  // which is not looked up
            const glm::vec2 texel = glm::clamp(glm::floor(at(s)), -200.0f, 200.0f);
            do
                for (int axis : {0, 1}) s.x[0][axis] = texel[axis] + static_cast<float>(2 * r.below(128) + 1) / 256.0f;
            while (!accepted(s));
        };
    return all;
}

/// receivers() off borders, all of them inside texel space.
[[nodiscard]] inline std::vector<input_class> points_of_texels() {
    std::vector<input_class> all = receivers_with([](const sample& s) { return off_borders(at(s)); });
    for (input_class& c : all)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            if (!umbrage::inside_texel_space(at(s))) s.x[0].x = s.x[0].y = 0.5f;
        };
    return all;
}

}  // namespace parity
