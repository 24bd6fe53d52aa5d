// SPDX-License-Identifier: MIT
#include <umbrage/debug/false_color.hpp>

#include "../entries.hpp"

namespace parity {

void add_debug_false_color(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back({.primitive = &glsl::false_color,
                   .classes = spread({{0.0f, 1.0f}}, depth_values()),
                   .twin = [](const sample& s) { return vec4(false_color(s.x[0].x), 1.0f); },
                   .call = "vec4(umbrage_false_color(x0.x), 1.0)"});
}

}  // namespace parity
