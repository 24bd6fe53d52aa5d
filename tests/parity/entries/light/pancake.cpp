// SPDX-License-Identifier: MIT
#include <algorithm>

#include <umbrage/light/pancake.hpp>

#include "../entries.hpp"

namespace parity {

void add_light_pancake(std::vector<entry>& all) {
    auto positions = spread({{-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f}, {-9.0f, 9.0f}}, special_values());
    // a denormal that compares as a zero is handed on as it is, which is neither what it becomes nor what a zero does
    positions.erase(
        std::remove_if(positions.begin(), positions.end(), [](const input_class& c) { return c.name == "denormal"; }),
        positions.end());
    for (input_class& c : positions)
        c.fill = [position = c.fill](std::uint64_t i, random& r, sample& s) {
            position(i, r, s);
            s.x[1].x = static_cast<float>(r.below(3)) - 1.0f;
        };
    all.push_back({.primitive = &umbrage::glsl::pancake,
                   .classes = positions,
                   .twin = [](const sample& s) { return umbrage::pancake(s.x[0], s.x[1].x); },
                   .call = "umbrage_pancake(x0, x1.x)"});
}

}  // namespace parity
