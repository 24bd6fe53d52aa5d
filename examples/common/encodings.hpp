// SPDX-License-Identifier: MIT
//
// Every encoding of the library by name. An encoding has texel, encode and decode; `below` is how far decode may
// answer below the depth that was encoded, which a receiver's bias has to cover.
//
//     example::with_encoding("rg11", umbrage::upper_edge<float>, [&](auto encoding, float below) { ... });
//
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/foreign/threejs.hpp>

namespace example {

inline const std::vector<std::string> encoding_names{
    "float", "rg9", "rg10", "rg11", "rg12", "rg13", "rg14", "rg15", "rg16", "rgb24", "float_bits",
    "threejs_rgba", "threejs_rgb", "threejs_rg", "threejs_legacy", "threejs_legacy_repaired", "base255", "base255_repaired"};

/// Somebody else's format: a writer of UNORM values or of bytes, and a reader of what sampling gives back.
/// The 8-bit store between the two is part of the format.
template <class Write, class Read>
struct foreign {
    Write write;
    Read read;

    static auto store(auto unorm) { return umbrage::store_unorm8(unorm); }
    static auto store(glm::u8vec4 bytes) { return bytes; }
    using texel = decltype(store(std::declval<Write>()(0.0f)));

    [[nodiscard]] texel encode(float depth) const { return store(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return read(umbrage::load_unorm8(t)); }
};

/// Calls use(encoding, below) with the encoding of that name; `edge` is for those that leave it open.
/// @throws std::invalid_argument  no such name
template <class Use>
auto with_encoding(std::string_view name, float edge, Use&& use) {
    const auto own = [&](auto encoding) {
        encoding.edge = edge;
        return use(encoding, (1.0f - edge) * static_cast<float>(encoding.max_error));
    };
    const auto others = [&](auto write, auto read, float below) {
        return use(foreign<decltype(write), decltype(read)>{write, read}, below);
    };
    using namespace umbrage;
    const auto read_legacy = [](glm::vec4 c) { return decode_threejs_legacy(c); };
    const auto read_base255 = [](glm::vec4 c) { return decode_base255(c); };
    if (name == "float") return use(depth32f{}, 0.0f);
    if (name == "float_bits") return use(float_bits{}, 0.0f);
    if (name == "rg9") return own(rg<9>{});
    if (name == "rg10") return own(rg<10>{});
    if (name == "rg11") return own(rg<11>{});
    if (name == "rg12") return own(rg<12>{});
    if (name == "rg13") return own(rg<13>{});
    if (name == "rg14") return own(rg<14>{});
    if (name == "rg15") return own(rg<15>{});
    if (name == "rg16") return own(rg<16>{});
    if (name == "rgb24") return own(rgb24{});
    if (name == "threejs_rgba")
        return others([](float d) { return write_threejs_rgba(d); },
                      [](glm::vec4 c) { return decode_threejs_rgba(c); }, 0x1p-24f);
    if (name == "threejs_rgb")
        return others([](float d) { return write_threejs_rgb(d); },
                      [](glm::vec3 c) { return decode_threejs_rgb(c); }, 0x1p-23f);
    if (name == "threejs_rg")
        return others([](float d) { return write_threejs_rg(d); },
                      [](glm::vec2 c) { return decode_threejs_rg(c); }, 0x1p-16f);
    if (name == "threejs_legacy") return others([](float d) { return write_threejs_legacy(d); }, read_legacy, 0x1p-23f);
    if (name == "threejs_legacy_repaired")
        return others([](float d) { return encode_threejs_legacy_repaired(d); }, read_legacy, 0x1p-23f);
    if (name == "base255") return others([](float d) { return write_base255(d); }, read_base255, 0x1p-21f);
    if (name == "base255_repaired") return others([](float d) { return encode_base255_repaired(d); }, read_base255, 0x1p-21f);
    throw std::invalid_argument("no encoding is called " + std::string(name));
}

}  // namespace example
