// SPDX-License-Identifier: MIT
//
// An encoding of the library in a shader: how its snippets are called, and what an empty map holds.
//
//     viewer::stored_as e = viewer::encoding_called("rg11");
//     e.write("depth");  // "vec4(umbrage_to_unorm(umbrage_encode_rg11(depth)), 0.0, 0.0)"
//
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <glm/vec4.hpp>

#include <umbrage/depth/encodings.hpp>

namespace viewer {

namespace glsl = umbrage::glsl;

struct stored_as {
    const glsl::snippet *writer, *reader;  ///< the latter is none for a float map
    umbrage::written writes;
    int channels;
    bool edge;          ///< the reader asks which edge of a code's interval it shall answer
    float below;        ///< how far it may answer below the depth that was written
    glm::vec4 cleared;  ///< what an empty texel is cleared to

    [[nodiscard]] bool floats() const { return !reader; }

    /// Expression of type vec4: what to write into the map.
    [[nodiscard]] std::string write(const std::string& depth) const {
        constexpr std::array zeros{"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
        std::string value = "umbrage_" + std::string(writer->name) + "(" + depth + ")";
        if (writes == umbrage::written::bytes) value = "umbrage_to_unorm(" + value + ")";
        return "vec4(" + value + zeros[static_cast<std::size_t>(channels)] + ")";
    }

    /// Expression of type float: the depth behind a vec4 from the map.
    [[nodiscard]] std::string read(const std::string& texel) const {
        const std::string values = texel + "." + std::string("xyzw").substr(0, static_cast<std::size_t>(channels));
        return floats() ? values : "umbrage_" + std::string(reader->name) + "(" + values + (edge ? ", 1.0)" : ")");
    }

    [[nodiscard]] std::vector<glsl::snippet> writers() const { return {*writer, glsl::to_unorm}; }
    [[nodiscard]] std::vector<glsl::snippet> readers() const {
        if (floats()) return {};
        return {*reader};
    }

    /// Whether bytes and GLSL 100 are enough.
    [[nodiscard]] bool on_es2() const {
        return !floats() && supports(*writer, glsl::version::v100) && supports(*reader, glsl::version::v100);
    }
};

/// @throws std::invalid_argument  no such name
[[nodiscard]] inline stored_as encoding_called(std::string_view name) {
    stored_as out{};
    const bool found = umbrage::with_encoding(name, [&]<class Encoding>(const Encoding& encoding) {
        const auto texel = encoding.cleared();
        glm::vec4 cleared(0);
        int channels = 1;
        if constexpr (std::is_same_v<typename Encoding::texel, float>) cleared.x = texel;
        else
            for (channels = 0; channels < texel.length(); ++channels)
                cleared[channels] = static_cast<float>(texel[channels]) / 255.0f;
        out = {Encoding::writer,
               Encoding::reader,
               Encoding::writes,
               channels,
               umbrage::has_edge<Encoding>,
               static_cast<float>(encoding.error().below),
               cleared};
    });
    if (!found) throw std::invalid_argument("no encoding is called " + std::string(name));
    return out;
}

}  // namespace viewer
