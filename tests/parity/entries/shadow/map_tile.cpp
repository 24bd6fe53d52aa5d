// SPDX-License-Identifier: MIT
#include <umbrage/shadow/map_tile.hpp>

#include "../entries.hpp"

namespace parity {

void add_shadow_map_tile(std::vector<entry>& all) {
    const auto numbers = [](std::uint64_t i, random& r, sample& s) {
        const int columns = 1 + static_cast<int>(i % 8);
        s.x[0] = vec4(static_cast<float>(r.below(i % 2 == 0 ? 64 : 65536)), static_cast<float>(columns),
                      1.0f / static_cast<float>(columns), 0.0f);
    };
    all.push_back({.primitive = &umbrage::glsl::map_tile,
                   .classes = {{"numbers", numbers}},
                   .twin =
                       [](const sample& s) {
                           const ivec2 size(128, 64);
                           const int number = static_cast<int>(s.x[0].x), columns = static_cast<int>(s.x[0].y);
                           return vec4(vec2(umbrage::map_tile(number, columns, size)), 0.0f, 1.0f);
                       },
                   .call = "vec4(umbrage_map_tile(x0.x, vec2(x0.y, x0.z), vec2(128.0, 64.0)), 0.0, 1.0)"});
}

}  // namespace parity
