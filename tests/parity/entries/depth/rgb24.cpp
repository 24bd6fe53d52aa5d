// SPDX-License-Identifier: MIT
#include <algorithm>

#include <umbrage/depth/rgb24.hpp>

#include "at_ends.hpp"

namespace parity {
namespace {

using namespace umbrage;

vec4 rgb24_of(const sample& s) { return vec4(vec3(encode_rgb24(s.x[0].x)), 255.0f); }

}  // namespace

void add_depth_rgb24(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    const auto depths = spread({{0.0f, 1.0f}}, depth_values(24));
    auto codes = channels(true);
    std::transform(codes.begin(), codes.end(), codes.begin(), at_ends);
    std::erase_if(codes, [](const input_class& kind) { return kind.name == "out of range"; });  // no sum below 2^24
    enumeration all_ends = all_codes();
    all_ends.all = at_ends(all_ends.all);

    all.push_back({.primitive = &glsl::encode_rgb24,
                   .classes = depths,
                   .whole = all_depths(),
                   .twin = rgb24_of,
                   .call = "vec4(umbrage_encode_rgb24(x0.x), 255.0)",
                   .bits = true});
    all.push_back({.primitive = &glsl::encode_rgb24,
                   .variant = "8-bit target",
                   .classes = depths,
                   .twin = rgb24_of,
                   .call = "umbrage_to_unorm(vec4(umbrage_encode_rgb24(x0.x), 255.0))",
                   .also = {&glsl::to_unorm},
                   .output = target::rgba8,
                   .bits = true});
    all.push_back({.primitive = &glsl::decode_rgb24,
                   .classes = codes,
                   .whole = all_ends,
                   .twin = [](const sample& s) { return vec4(decode_rgb24(vec3(s.x[0]), s.x[1].x)); },
                   .call = "vec4(umbrage_decode_rgb24(vec3(x0.x, x0.y, x0.z), x1.x))"});
}

}  // namespace parity
