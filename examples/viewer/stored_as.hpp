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

#include <umbrage/core/texel_space.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/shader/glsl.hpp>

namespace viewer {

namespace glsl = umbrage::glsl;

struct stored_as {
    const glsl::snippet* writer;
    umbrage::written writes;
    glsl::binding map;  ///< as shaders read it
    float below;        ///< how far a reader may answer below the depth that was written
    glm::vec4 cleared;  ///< what an empty texel is cleared to

    [[nodiscard]] bool floats() const { return map.needs.empty(); }

    /// Expression of type vec4: what to write into the map.
    [[nodiscard]] std::string write(const std::string& depth) const {
        constexpr std::array zeros{"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
        std::string value = "umbrage_" + std::string(writer->name) + "(" + depth + ")";
        if (writes == umbrage::written::bytes) value = "umbrage_to_unorm(" + value + ")";
        return "vec4(" + value + zeros[static_cast<std::size_t>(map.channels)] + ")";
    }

    [[nodiscard]] std::vector<glsl::snippet> writers() const { return {*writer, glsl::to_unorm}; }

    /// Whether bytes and GLSL 100 are enough.
    [[nodiscard]] bool on_es2() const {
        return !floats() && supports(*writer, glsl::version::v100) &&
               supports(bind(glsl::fetch_depth, "", map), glsl::version::v100);
    }
};

/// @throws std::invalid_argument  no such name
[[nodiscard]] inline stored_as encoding_called(std::string_view name) {
    stored_as out{};
    const bool found = umbrage::with_encoding(name, [&]<class Encoding>(const Encoding& encoding) {
        const auto texel = encoding.cleared();
        glm::vec4 cleared(0);
        if constexpr (std::is_same_v<typename Encoding::texel, float>) cleared.x = texel;
        else
            for (int c = 0; c < texel.length(); ++c) cleared[c] = static_cast<float>(texel[c]) / 255.0f;
        out = {Encoding::writer, Encoding::writes, glsl::stored_as(encoding),
               static_cast<float>(encoding.error().below), cleared};
    });
    if (!found) throw std::invalid_argument("no encoding is called " + std::string(name));
    return out;
}

}  // namespace viewer
