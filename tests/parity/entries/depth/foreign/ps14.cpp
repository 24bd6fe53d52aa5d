// SPDX-License-Identifier: MIT
#include <umbrage/depth/foreign/ps14.hpp>

#include "../../entries.hpp"

namespace parity {

void add_depth_foreign_ps14(std::vector<entry>& all) {
    using namespace umbrage;

    all.push_back({.primitive = &umbrage::glsl::decode_ps14,
                   .classes = channels(),
                   .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(decode_ps14(vec2(s.x[0]))); },
                   .call = "vec4(umbrage_decode_ps14(vec2(x0.x, x0.y)))"});
    all.push_back({.primitive = &umbrage::glsl::receiver_ps14,
                   .classes = spread({{0.0f, 1.0f}}, depth_values()),
                   .whole = all_depths(),
                   .twin = [](const sample& s) { return vec4(receiver_ps14(s.x[0].x)); },
                   .call = "vec4(umbrage_receiver_ps14(x0.x))"});
    all.push_back(levels(umbrage::glsl::decode_ps14, "umbrage_decode_ps14(value.xy)", umbrage::glsl::receiver_ps14,
                         "umbrage_receiver_ps14(x0.z)", [](const sample& s) {
                             const auto fetch = [view = s.map](ivec2 texel) {
                                 return decode_ps14(vec2(fetch_clamped(view, texel)));
                             };
                             return vec4(hard(fetch, at(s), receiver_ps14(s.x[0].z), less_equal_scaled{}));
                         }));
}

}  // namespace parity
