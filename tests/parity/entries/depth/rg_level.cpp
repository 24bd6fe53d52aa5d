// SPDX-License-Identifier: MIT
#include <utility>

#include <umbrage/depth/rg_level.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Bits>
void add_levels(std::vector<entry>& all) {
    all.push_back({.primitive = &umbrage::glsl::level_rg<Bits>,
                   .classes = channels(),
                   .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(level_rg<Bits>(vec2(s.x[0]))); },
                   .call = "vec4(umbrage_level_rg" + std::to_string(Bits) + "(vec2(x0.x, x0.y)))"});
    all.push_back({.primitive = &umbrage::glsl::receiver_rg<Bits>,
                   .classes = spread({{0.0f, 1.0f}, {0.0f, 1.0f}}, depth_values(Bits)),
                   .whole = all_depths(),
                   .twin = [](const sample& s) { return vec4(receiver_rg<Bits>(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_receiver_rg" + std::to_string(Bits) + "(x0.x, x0.y))"});
}

}  // namespace

void add_depth_rg_level(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    [&]<int... M>(std::integer_sequence<int, M...>) { (add_levels<9 + M>(all), ...); }
    (std::make_integer_sequence<int, 8>());
    all.push_back(levels(glsl::level_rg<11>, "umbrage_level_rg11(value.xy)", glsl::receiver_rg<11>,
                         "umbrage_receiver_rg11(x0.z, 0.5)", [](const sample& s) {
                             const auto fetch = [view = s.map](ivec2 texel) {
                                 return level_rg<11>(vec2(fetch_clamped(view, texel)));
                             };
                             return vec4(hard(fetch, at(s), receiver_rg<11>(s.x[0].z, 0.5f), less_equal_scaled{}));
                         }));
}

}  // namespace parity
