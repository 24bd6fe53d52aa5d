// SPDX-License-Identifier: MIT
#include <umbrage/depth/r16.hpp>

#include "../entries.hpp"

namespace parity {

void add_depth_r16(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back({.primitive = &glsl::encode_r16,
                   .classes = spread({{0.0f, 1.0f}}, depth_values(16)),
                   .whole = all_depths(),
                   .twin = [](const sample& s) { return vec4(static_cast<float>(encode_r16(s.x[0].x))); },
                   .call = "vec4(umbrage_encode_r16(x0.x))",
                   .bits = true});
    all.push_back({.primitive = &glsl::decode_r16,
                   .classes = channels(true, 16),
                   .twin = [](const sample& s) { return vec4(decode_r16(s.x[0].x, s.x[1].x)); },
                   .call = "vec4(umbrage_decode_r16(x0.x, x1.x))"});
}

}  // namespace parity
