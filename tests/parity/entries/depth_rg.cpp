// SPDX-License-Identifier: MIT
#include <utility>

#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>

#include "entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Bits>
vec4 encoded(const sample& s) {
    return vec4(vec2(encode_rg<Bits>(s.x[0].x)), 0.0f, 255.0f);
}

template <int Bits>
texels table() {
    auto* make = make_rg_table<Bits, glm::u8vec4>;  // through a pointer: compilers take minutes to make the large ones
    const auto bytes = make();
    texels t(rg_table_size<Bits>);
    for (std::size_t x = 0; x < bytes.size(); ++x) t.texels()[x] = load_unorm8(bytes[x]);
    return t;
}

template <int Bits>
void add(std::vector<entry>& all) {
    const std::string name = "umbrage_encode_rg" + std::to_string(Bits);
    const auto depths = spread({{0.0f, 1.0f}}, depth_values(Bits));
    all.push_back({.primitive = &umbrage::glsl::encode_rg<Bits>, .classes = depths, .whole = all_depths(), .twin = encoded<Bits>,
                   .call = "vec4(" + name + "(x0.x), 0.0, 255.0)", .bits = true});
    all.push_back({.primitive = &umbrage::glsl::encode_rg<Bits>, .variant = "8-bit target", .classes = depths,
                   .twin = encoded<Bits>, .call = "umbrage_to_unorm(vec4(" + name + "(x0.x), 0.0, 255.0))",
                   .also = {&umbrage::glsl::to_unorm}, .output = target::rgba8, .bits = true});
    all.push_back({.primitive = &umbrage::glsl::encode_rg_table<Bits>, .classes = depths, .whole = all_depths(),
                   .twin = encoded<Bits>, .call = "vec4(" + name + "_table(table, x0.x), 0.0, 255.0)", .table = table<Bits>(), .bits = true});
    all.push_back({.primitive = &umbrage::glsl::decode_rg<Bits>, .classes = channels(true), .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(decode_rg<Bits>(vec2(s.x[0]), s.x[1].x)); },
                   .call = "vec4(umbrage_decode_rg" + std::to_string(Bits) + "(vec2(x0.x, x0.y), x1.x))"});
    all.push_back({.primitive = &umbrage::glsl::level_rg<Bits>, .classes = channels(), .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(level_rg<Bits>(vec2(s.x[0]))); },
                   .call = "vec4(umbrage_level_rg" + std::to_string(Bits) + "(vec2(x0.x, x0.y)))"});
    all.push_back({.primitive = &umbrage::glsl::receiver_rg<Bits>,
                   .classes = spread({{0.0f, 1.0f}, {0.0f, 1.0f}}, depth_values(Bits)), .whole = all_depths(),
                   .twin = [](const sample& s) { return vec4(receiver_rg<Bits>(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_receiver_rg" + std::to_string(Bits) + "(x0.x, x0.y))"});
}

}  // namespace

void add_depth_rg(std::vector<entry>& all) {
    [&]<int... M>(std::integer_sequence<int, M...>) { (add<9 + M>(all), ...); }(std::make_integer_sequence<int, 8>());

    all.push_back({.primitive = &umbrage::glsl::decode_ps14, .classes = channels(), .whole = all_codes(),
                   .twin = [](const sample& s) { return vec4(decode_ps14(vec2(s.x[0]))); },
                   .call = "vec4(umbrage_decode_ps14(vec2(x0.x, x0.y)))"});
    all.push_back({.primitive = &umbrage::glsl::receiver_ps14, .classes = spread({{0.0f, 1.0f}}, depth_values()),
                   .whole = all_depths(), .twin = [](const sample& s) { return vec4(receiver_ps14(s.x[0].x)); },
                   .call = "vec4(umbrage_receiver_ps14(x0.x))"});
}

}  // namespace parity
