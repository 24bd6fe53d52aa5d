// SPDX-License-Identifier: MIT
#include <umbrage/filter/bounds_lit.hpp>

#include "../entries.hpp"

namespace parity {

void add_filter_bounds_lit(std::vector<entry>& all) {
    using namespace umbrage;
    const auto lit = [](const sample& s, auto... is_lit) {
        const auto bounds = [view = s.map](ivec2 at) { return vec2(fetch_clamped(view, at)); };
        return vec4(bounds_lit(bounds, at(s), s.x[0].z, vec2(639.0f, 1.0f / 512.0f), is_lit...));
    };
    const std::string place = ", vec2(639.0, 1.0 / 512.0)";
    all.push_back(filter(glsl::bounds_lit, place, [lit](const sample& s) { return lit(s); }));
    all.push_back(reversed_filter(glsl::bounds_lit, place, [lit](const sample& s) { return lit(s, greater_equal{}); }));
}

}  // namespace parity
