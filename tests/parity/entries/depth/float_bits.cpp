// SPDX-License-Identifier: MIT
#include <umbrage/depth/float_bits.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

vec4 bits_of(const sample& s) { return vec4(encode_float_bits(s.x[0].x)); }

}  // namespace

void add_depth_float_bits(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    const auto depths = spread({{0.0f, 1.0f}}, depth_values(24));

    all.push_back({.primitive = &glsl::encode_float_bits,
                   .classes = depths,
                   .whole = all_depths(),
                   .twin = bits_of,
                   .call = "umbrage_encode_float_bits(x0.x)",
                   .bits = true});
    all.push_back({.primitive = &glsl::encode_float_bits,
                   .variant = "8-bit target",
                   .classes = depths,
                   .twin = bits_of,
                   .call = "umbrage_to_unorm(umbrage_encode_float_bits(x0.x))",
                   .also = {&glsl::to_unorm},
                   .output = target::rgba8,
                   .bits = true});
    all.push_back({.primitive = &glsl::decode_float_bits,
                   .classes = channels(),
                   .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(decode_float_bits(s.x[0])); },
                   .call = "vec4(umbrage_decode_float_bits(x0))",
                   .bits = true});
}

}  // namespace parity
