// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/windows.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Every fraction of 1/256 in both directions, with comparisons that fall either way.
enumeration all_fractions() {
    return {{"256 x 256 fractions",
             [](std::uint64_t i, random& r, sample& s) {
                 const ivec2 texel{r.below(s.map.size.x), r.below(s.map.size.y)};
                 const vec2 fraction(static_cast<float>(i & 255), static_cast<float>(i >> 8));
                 s.x[0] = vec4(vec2(texel) + fraction / 256.0f, s.depth()(texel), 0.0f);
             }},
            1 << 16};
}

}  // namespace

void add_filter_pcf_windows(std::vector<entry>& all) {
    for (const filters::window& one : filters::window::values) {
        all.push_back(filter(
            *one.snippet, "", [one](const sample& s) { return vec4(one(s.depth(), at(s), s.x[0].z)); },
            all_fractions()));
        all.back().share = static_cast<std::size_t>(one.row.size);
        all.back().alike = one.row.size > 2;
    }
    using umbrage::glsl::texture;
    const auto gathered = [&](const filters::window& one, const char* of, umbrage::glsl::binding as) {
        as.gather = true;
        all.push_back(bound_filter(*one.snippet, "", of, as, [one](auto fetch, const sample& s, comparison is_lit) {
            filters::window same = one;
            same.direction = is_lit.direction;
            return same(fetch, at(s), s.x[0].z);
        }));
    };
    gathered(filters::tent<2>, "gathered", {.outside = outside_map::clamped});
    gathered(filters::tent<2>, "gathered comparisons, lit outside", {.texture = texture::shadow});
    gathered(filters::tent<3>, "gathered", {.outside = outside_map::clamped});
    gathered(filters::tent<3>, "gathered comparisons, reversed",
             {.texture = texture::shadow, .direction = depth_direction::reversed, .outside = outside_map::clamped});
    gathered(filters::castano_dyadic<5>, "gathered, lit outside", {});
    gathered(filters::castano_dyadic<5>, "gathered comparisons",
             {.texture = texture::shadow, .outside = outside_map::clamped});
    filters::window reversed = filters::binomial<5>;
    reversed.direction = depth_direction::reversed;
    all.push_back(reversed_filter(*reversed.snippet, "",
                                  [reversed](const sample& s) { return vec4(reversed(s.depth(), at(s), s.x[0].z)); }));
    all.back().share = 8;
    all.back().alike = true;
}

}  // namespace parity
