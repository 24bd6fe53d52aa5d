// SPDX-License-Identifier: MIT
//
// The GLSL side of common/encodings.hpp: which snippets write and read a depth, and how they are called.
//
//     viewer::encoding e = viewer::encoding_called("rg11");
//     e.write("depth");  // "vec4(umbrage_to_unorm(umbrage_encode_rg11(depth)), 0.0, 0.0)"
//
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/depth/foreign/threejs_legacy.hpp>

namespace viewer {

namespace glsl = umbrage::glsl;

struct encoding {
    std::string_view name;
    const glsl::snippet *encode = nullptr, *decode = nullptr;  ///< none: a float map
    int channels = 1;
    bool whole = true;  ///< the encoder gives whole channels 0..255, which umbrage_to_unorm makes ready to be written
    bool edge = true;   ///< the decoder asks which edge of a code's interval it shall answer

    [[nodiscard]] bool floats() const { return !encode; }

    /// Expression of type vec4: what to write into the map.
    [[nodiscard]] std::string write(const std::string& depth) const {
        constexpr std::array zeros{"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
        if (floats()) return "vec4(umbrage_saturate(" + depth + "))";
        const std::string channel_values = "umbrage_" + std::string(encode->name) + "(" + depth + ")";
        return "vec4(" + (whole ? "umbrage_to_unorm(" + channel_values + ")" : channel_values) +
               zeros[static_cast<std::size_t>(channels)] + ")";
    }

    /// Expression of type float: the depth behind a vec4 from the map.
    [[nodiscard]] std::string read(const std::string& texel) const {
        if (floats()) return texel + ".x";
        return "umbrage_" + std::string(decode->name) + "(" + texel + "." +
               std::string("xyzw").substr(0, static_cast<std::size_t>(channels)) + (edge ? ", 1.0)" : ")");
    }

    [[nodiscard]] std::vector<glsl::snippet> writers() const {
        if (floats()) return {glsl::saturate};
        return {*encode, glsl::to_unorm};
    }
    [[nodiscard]] std::vector<glsl::snippet> readers() const {
        if (floats()) return {};
        return {*decode};
    }
};

/// Whether bytes and GLSL 100 are enough.
[[nodiscard]] inline bool on_es2(const encoding& e) {
    return !e.floats() && supports(*e.encode, glsl::version::v100) && supports(*e.decode, glsl::version::v100);
}

inline constexpr std::array encodings{
    encoding{"depth32f"},
    encoding{"rg9", &glsl::encode_rg<9>, &glsl::decode_rg<9>, 2},
    encoding{"rg10", &glsl::encode_rg<10>, &glsl::decode_rg<10>, 2},
    encoding{"rg11", &glsl::encode_rg<11>, &glsl::decode_rg<11>, 2},
    encoding{"rg12", &glsl::encode_rg<12>, &glsl::decode_rg<12>, 2},
    encoding{"rg13", &glsl::encode_rg<13>, &glsl::decode_rg<13>, 2},
    encoding{"rg14", &glsl::encode_rg<14>, &glsl::decode_rg<14>, 2},
    encoding{"rg15", &glsl::encode_rg<15>, &glsl::decode_rg<15>, 2},
    encoding{"rg16", &glsl::encode_rg<16>, &glsl::decode_rg<16>, 2},
    encoding{"rgb24", &glsl::encode_rgb24, &glsl::decode_rgb24, 3},
    encoding{"float_bits", &glsl::encode_float_bits, &glsl::decode_float_bits, 4, true, false},
    encoding{"threejs_rgba", &glsl::write_threejs_rgba, &glsl::decode_threejs_rgba, 4, false, false},
    encoding{"threejs_rgb", &glsl::write_threejs_rgb, &glsl::decode_threejs_rgb, 3, false, false},
    encoding{"threejs_rg", &glsl::write_threejs_rg, &glsl::decode_threejs_rg, 2, false, false},
    encoding{"threejs_legacy", &glsl::write_threejs_legacy, &glsl::decode_threejs_legacy, 4, false, false},
    encoding{"threejs_legacy_repaired", &glsl::encode_threejs_legacy_repaired, &glsl::decode_threejs_legacy, 4, true, false},
    encoding{"base255", &glsl::write_base255, &glsl::decode_base255, 4, false, false},
    encoding{"base255_repaired", &glsl::encode_base255_repaired, &glsl::decode_base255, 4, true, false}};

/// @throws std::invalid_argument  no such name
[[nodiscard]] inline const encoding& encoding_called(std::string_view name) {
    for (const encoding& e : encodings)
        if (e.name == name) return e;
    throw std::invalid_argument("no encoding is called " + std::string(name));
}

}  // namespace viewer
