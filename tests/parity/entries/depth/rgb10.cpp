// SPDX-License-Identifier: MIT
#include <algorithm>

#include <umbrage/depth/rgb10.hpp>

#include "at_ends.hpp"

namespace parity {

void add_depth_rgb10(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    auto codes = channels(true, 10);
    std::transform(codes.begin(), codes.end(), codes.begin(), at_ends);
    std::erase_if(codes, [](const input_class& kind) { return kind.name == "out of range"; });  // no sum below 2^24

    all.push_back({.primitive = &glsl::encode_rgb10,
                   .classes = spread({{0.0f, 1.0f}}, depth_values(24)),
                   .whole = all_depths(),
                   .twin = [](const sample& s) { return vec4(vec3(encode_rgb10(s.x[0].x)), 1023.0f); },
                   .call = "vec4(umbrage_encode_rgb10(x0.x), 1023.0)",
                   .bits = true});
    all.push_back({.primitive = &glsl::decode_rgb10,
                   .classes = codes,
                   .twin = [](const sample& s) { return vec4(decode_rgb10(vec3(s.x[0]), s.x[1].x)); },
                   .call = "vec4(umbrage_decode_rgb10(vec3(x0.x, x0.y, x0.z), x1.x))"});
}

}  // namespace parity
