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

#include "gl.hpp"

namespace viewer {

namespace glsl = umbrage::glsl;

/// The target that an encoding needs.
template <class Target>
[[nodiscard]] constexpr texels_of texels_for() {
    if constexpr (Target::to_unorm == nullptr)  // of 16 bits a color's store is that of depth; floats hold 24
        return std::is_same_v<Target, umbrage::depth_texture<16>> ? texels_of::shorts : texels_of::depth;
    else return Target::bits == 8 ? texels_of::bytes : (Target::bits == 10 ? texels_of::tens : texels_of::shorts);
}

struct stored_as {
    const glsl::snippet* writer;
    const glsl::snippet* to_unorm;  ///< conversion of integer channels; null: the writer's result is written
    texels_of texels;
    glsl::binding map;  ///< as shaders read it
    float below;        ///< largest amount by which a decoded depth lies below the written one
    glm::vec4 cleared;  ///< cleared texel

    /// Expression of type vec4: what to write into the map.
    [[nodiscard]] std::string write(const std::string& depth) const {
        constexpr std::array zeros{"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""};
        std::string value = "umbrage_" + std::string(writer->name) + "(" + depth + ")";
        if (to_unorm) value = "umbrage_" + std::string(to_unorm->name) + "(" + value + ")";
        return "vec4(" + value + zeros[static_cast<std::size_t>(map.channels)] + ")";
    }

    [[nodiscard]] std::vector<glsl::snippet> writers() const {
        if (to_unorm) return {*writer, *to_unorm};
        return {*writer};
    }

    /// True when bytes and GLSL 100 are enough.
    [[nodiscard]] bool on_es2() const {
        return texels == texels_of::bytes && supports(*writer, glsl::version::v100) &&
               supports(bind(glsl::fetch_depth, "", map), glsl::version::v100);
    }
};

/// @throws std::invalid_argument  no such name
[[nodiscard]] inline stored_as encoding_called(std::string_view name) {
    stored_as out{};
    const bool found = umbrage::with_encoding(name, [&]<class Encoding>(const Encoding& encoding) {
        using kept = typename Encoding::target;
        out = {Encoding::writer,
               Encoding::writes == umbrage::store_format::integers ? kept::to_unorm : nullptr,
               texels_for<kept>(),
               glsl::stored_as(encoding),
               static_cast<float>(encoding.error().below),
               kept::load(encoding.cleared())};
    });
    if (!found) throw std::invalid_argument("no encoding is called " + std::string(name));
    return out;
}

}  // namespace viewer
