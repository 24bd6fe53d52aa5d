// SPDX-License-Identifier: MIT
#include <umbrage/shadow/softness.hpp>

#include "../entries.hpp"

namespace parity {

void add_shadow_softness(std::vector<entry>& all) {
    const auto numbers = [](std::uint64_t i, random& r, sample& s) {
        for (std::size_t column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) s.x[column][row] = r.unit();
        s.x[4].x = static_cast<float>(i % 8);
    };
    all.push_back({.primitive = &umbrage::glsl::map_softness,
                   .classes = {{"numbers", numbers}},
                   .twin =
                       [](const sample& s) {
                           const vec2 own = umbrage::map_softness(glm::mat4(s.x[0], s.x[1], s.x[2], s.x[3]), s.x[4].x);
                           return vec4(own.x, own.y, 0.0f, 1.0f);
                       },
                   .call = "vec4(umbrage_map_softness(mat4(x0, x1, x2, x3), x4.x), 0.0, 1.0)"});
}

}  // namespace parity
