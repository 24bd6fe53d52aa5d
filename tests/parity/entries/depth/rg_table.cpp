// SPDX-License-Identifier: MIT
#include <utility>

#include <umbrage/depth/rg_table.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Bits>
texels table() {
    auto* make = make_rg_table<Bits, glm::u8vec4>;  // through a pointer: compilers take minutes to make the large ones
    const auto bytes = make();
    texels t(rg_table_size<Bits>);
    for (std::size_t x = 0; x < bytes.size(); ++x) t.texels()[x] = load_unorm(bytes[x]);
    return t;
}

template <int Bits>
void add_table(std::vector<entry>& all) {
    const std::string name = "umbrage_encode_rg" + std::to_string(Bits) + "_table";
    all.push_back({.primitive = &umbrage::glsl::encode_rg_table<Bits>,
                   .classes = spread({{0.0f, 1.0f}}, depth_values(Bits)),
                   .whole = all_depths(),
                   .twin = [](const sample& s) { return vec4(vec2(encode_rg<Bits>(s.x[0].x)), 0.0f, 255.0f); },
                   .call = "vec4(" + name + "(table, x0.x), 0.0, 255.0)",
                   .table = table<Bits>(),
                   .bits = true});
}

}  // namespace

void add_depth_rg_table(std::vector<entry>& all) {
    [&]<int... M>(std::integer_sequence<int, M...>) { (add_table<9 + M>(all), ...); }
    (std::make_integer_sequence<int, 8>());
}

}  // namespace parity
