// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/four_tap.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// receivers() with three more taps beside the first in x1 and x2.xy.
std::vector<input_class> four_taps() {
    auto classes = receivers();
    for (input_class& c : classes)
        c.fill = [one = c.fill](std::uint64_t i, random& r, sample& s) {
            one(i, r, s);
            const auto beside = [&](int lane) { return s.x[0][lane] + r.between(-1.5f, 1.5f); };
            s.x[1] = {beside(0), beside(1), beside(0), beside(1)};
            s.x[2] = {beside(0), beside(1), 0.0f, 0.0f};
        };
    return classes;
}

vec4 taps(const sample& s, auto... is_lit) {
    const vec4 x = s.x[1];
    return vec4(four_tap(s.depth(), at(s), vec2(x.x, x.y), vec2(x.z, x.w), vec2(s.x[2]), s.x[0].z, is_lit...));
}

}  // namespace

void add_filter_pcf_four_tap(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    const std::string call =
        "vec4(umbrage_four_tap(map, map_size, vec2(x0.x, x0.y), vec2(x1.x, x1.y), vec2(x1.z, x1.w), vec2(x2.x, x2.y), "
        "x0.z))";
    all.push_back({.primitive = &glsl::four_tap,
                   .classes = four_taps(),
                   .twin = [](const sample& s) { return taps(s); },
                   .call = call,
                   .maps = depth_maps()});
    all.push_back({.primitive = &glsl::four_tap,
                   .variant = "reversed",
                   .classes = four_taps(),
                   .twin = [](const sample& s) { return taps(s, greater_equal{}); },
                   .call = call,
                   .maps = depth_maps(),
                   .map_kind = {.direction = umbrage::depth_direction::reversed, .outside = outside_map::clamped}});
}

}  // namespace parity
