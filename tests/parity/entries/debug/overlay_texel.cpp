// SPDX-License-Identifier: MIT
#include <umbrage/debug/overlay_texel.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

/// Coordinate, side of the overlay, side of the map, their quotient up to 16 ulp off.
vec4 overlaid(std::uint64_t i, random& r, int pixel, int size, int map_size) {
    const float ratio = static_cast<float>(map_size) / static_cast<float>(size);
    return {static_cast<float>(pixel) + 0.5f, size, map_size,
            i % 2 ? ratio
                  : umbrage::detail::bit_cast<float>(umbrage::detail::bit_cast<std::uint32_t>(ratio) - 16u +
                                                     r.bits() % 33u)};
}

vec4 any_sides(std::uint64_t i, random& r) {
    const int map_size = 1 + r.below(1 << (1 + r.below(16)));
    const int most = (1 << 23) / map_size, size = i % 3 ? 1 + r.below(most) : most;
    return overlaid(i, r, i % 5 ? r.below(size) : size - 1, size, map_size);
}

std::vector<input_class> overlays() {
    std::vector<input_class> classes{
        {"random", [](std::uint64_t i, random& r, sample& s) { s.x[0] = any_sides(i, r); }},
        {"centers on edges of texels",
         [](std::uint64_t i, random& r, sample& s) {
             const int odd = 3 + 2 * r.below(100), of_both = 1 + r.below(20);
             const int pixel = (odd * (1 + 2 * r.below(of_both)) - 1) / 2;
             s.x[0] = overlaid(i, r, pixel, odd * of_both, 2 * of_both * (1 + r.below(40)));
         }},
        {"around the ends", [](std::uint64_t i, random& r, sample& s) {
             s.x[0] = any_sides(i, r);
             s.x[0].x = (i % 2 ? s.x[0].y : 0.0f) + static_cast<float>(r.below(4) - 2) + 0.5f;
         }}};
    for (const value_class& kind : special_values())
        classes.push_back({kind.name, [kind](std::uint64_t i, random& r, sample& s) {
                               s.x[0] = any_sides(i, r);
                               s.x[0].x = kind.make(i, r);
                           }});
    return classes;
}

}  // namespace

void add_debug_overlay_texel(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back({.primitive = &glsl::overlay_texel,
                   .classes = overlays(),
                   .twin = [](const sample& s) { return vec4(overlay_texel(s.x[0].x, s.x[0].y, s.x[0].z, s.x[0].w)); },
                   .call = "vec4(umbrage_overlay_texel(x0.x, x0.y, x0.z, x0.w))"});
}

}  // namespace parity
