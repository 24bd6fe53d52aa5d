// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/reduce.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

auto fetch(const sample& s) {
    return [view = s.map](ivec2 t) { return fetch_clamped(view, t); };
}

template <int Taps>
void add_row(std::vector<entry>& all) {
    for (const bool down : {false, true})
        all.push_back({.primitive = &glsl::blur_row<Taps>,
                       .variant = down ? "y" : "x",
                       .classes = whole_texels(),
                       .twin =
                           [down](const sample& s) {
                               return blur_row<Taps>(fetch(s), texel_of(s), down ? ivec2(0, 1) : ivec2(1, 0));
                           },
                       .call = "umbrage_" + std::string(glsl::blur_row<Taps>.name) +
                               "(map, map_size, vec2(x0.x, x0.y), " + (down ? "vec2(0.0, 1.0))" : "vec2(1.0, 0.0))"),
                       .maps = packed_maps(),
                       .alike = Taps != 5});
}

}  // namespace

void add_filter_prefiltered_reduce(std::vector<entry>& all) {
    add_row<3>(all);
    add_row<5>(all);
    add_row<7>(all);
    all.push_back({.primitive = &glsl::halve_texels,
                   .classes = whole_texels(),
                   .twin = [](const sample& s) { return halve_texels(fetch(s), texel_of(s)); },
                   .call = "umbrage_halve_texels(map, map_size, vec2(x0.x, x0.y))",
                   .maps = packed_maps()});
}

}  // namespace parity
