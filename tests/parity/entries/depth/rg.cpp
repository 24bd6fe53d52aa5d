// SPDX-License-Identifier: MIT
#include <utility>

#include <umbrage/depth/rg.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Bits>
vec4 encoded(const sample& s) {
    return vec4(vec2(encode_rg<Bits>(s.x[0].x)), 0.0f, 255.0f);
}

template <int Bits>
void add(std::vector<entry>& all) {
    const std::string name = "umbrage_encode_rg" + std::to_string(Bits);
    const auto depths = spread({{0.0f, 1.0f}}, depth_values(Bits));
    all.push_back({.primitive = &umbrage::glsl::encode_rg<Bits>,
                   .classes = depths,
                   .whole = all_depths(),
                   .twin = encoded<Bits>,
                   .call = "vec4(" + name + "(x0.x), 0.0, 255.0)",
                   .bits = true});
    all.push_back({.primitive = &umbrage::glsl::encode_rg<Bits>,
                   .variant = "8-bit target",
                   .classes = depths,
                   .twin = encoded<Bits>,
                   .call = "umbrage_to_unorm(vec4(" + name + "(x0.x), 0.0, 255.0))",
                   .also = {&umbrage::glsl::to_unorm},
                   .output = target::rgba8,
                   .bits = true});
    all.push_back({.primitive = &umbrage::glsl::decode_rg<Bits>,
                   .classes = channels(true),
                   .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(decode_rg<Bits>(vec2(s.x[0]), s.x[1].x)); },
                   .call = "vec4(umbrage_decode_rg" + std::to_string(Bits) + "(vec2(x0.x, x0.y), x1.x))"});
}

}  // namespace

void add_depth_rg(std::vector<entry>& all) {
    [&]<int... M>(std::integer_sequence<int, M...>) { (add<9 + M>(all), ...); }
    (std::make_integer_sequence<int, 8>());
}

}  // namespace parity
