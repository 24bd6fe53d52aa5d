// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>

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
    auto registers = spread({{-9.0f, 9.0f}}, special_values());
    registers.push_back({"ties and their neighbors", [](std::uint64_t i, random& r, sample& s) {
                             const float tie = (std::floor(r.between(-33000.0f, 33000.0f)) + 0.5f) / 4096.0f;
                             s.x[0] = vec4(std::array{tie, std::nextafter(tie, 9.0f), std::nextafter(tie, -9.0f),
                                                      tie - 0x1p-13f}[i % 4]);
                         }});
    all.push_back({.primitive = &umbrage::glsl::fixed_ps14,
                   .classes = registers,
                   .twin = [](const sample& s) { return vec4(fixed_ps14(s.x[0].x)); },
                   .call = "vec4(umbrage_fixed_ps14(x0.x))"});
    all.push_back({.primitive = &umbrage::glsl::decode_fixed_ps14,
                   .classes = channels(),
                   .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(decode_fixed_ps14(vec2(s.x[0]))); },
                   .call = "vec4(umbrage_decode_fixed_ps14(vec2(x0.x, x0.y)))"});
    all.push_back(levels(umbrage::glsl::decode_ps14, "umbrage_decode_ps14(value.xy)", umbrage::glsl::receiver_ps14,
                         "umbrage_receiver_ps14(x0.z)", [](const sample& s) {
                             const auto fetch = [view = s.map](ivec2 texel) {
                                 return decode_ps14(vec2(fetch_clamped(view, texel)));
                             };
                             return vec4(hard(fetch, at(s), receiver_ps14(s.x[0].z), less_equal_scaled{}));
                         }));
    entry fixed =
        levels(umbrage::glsl::decode_fixed_ps14, "umbrage_decode_fixed_ps14(value.xy)", umbrage::glsl::receiver_ps14,
               "umbrage_fixed_ps14(umbrage_receiver_ps14(x0.z))", [](const sample& s) {
                   const auto fetch = [view = s.map](ivec2 texel) {
                       return decode_fixed_ps14(vec2(fetch_clamped(view, texel)));
                   };
                   const float receiver = fixed_ps14(receiver_ps14(s.x[0].z));
                   return vec4(hard(fetch, at(s), receiver, less_equal_scaled{}));
               });
    fixed.also.push_back(&umbrage::glsl::fixed_ps14);
    all.push_back(fixed);
}

}  // namespace parity
