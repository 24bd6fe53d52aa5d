// SPDX-License-Identifier: MIT
//
// The encodings in JavaScript: maps that bind() takes, and how their texels come about.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <type_traits>

#include <umbrage/shadow/depth_pass.hpp>

#include "module_words.hpp"

namespace package {

inline std::string encoding_of_module(const auto& encoding) {
    const glsl::binding map = glsl::stored_as(encoding);
    std::string cleared;
    for (const cleared_channel& c : cleared_channels(encoding))
        cleared += (cleared.empty() ? "" : ", ") + quotient(c.value, c.most);
    return "{ name: " + literal(encoding.name) +
           ", direction: " + literal(map.direction == umbrage::depth_direction::forward ? "forward" : "reversed") +
           ", depth: " + literal(map.depth) + ", channels: " + std::to_string(map.channels) + ", needs: [" +
           (map.needs.empty() ? "" : "snippets." + std::string(map.needs.front().name)) + "],\n    cleared: [" +
           cleared + "], format: " + literal(std::decay_t<decltype(encoding)>::target::format);
}

/// Functions that the depth pass of an encoding calls.
template <class Encoding>
[[nodiscard]] glsl::own_text write_of() {
    using target = typename Encoding::target;
    const bool integers = Encoding::writes == umbrage::store_format::integers;
    return glsl::detail::write_text(*Encoding::writer, integers ? target::to_unorm : nullptr, target::channels, "");
}

inline std::string encodings_module(const shader_language& l) {
    std::string out = "import { language } from './language.mjs';\nimport * as snippets from './snippets.mjs';\n";
    umbrage::for_each_encoding([&](auto encoding) {
        const std::string name(encoding.name), write = "write_" + name;
        out +=
            "\nconst " + write + " = " +
            own_snippet(l, write_of<decltype(encoding)>(), "color of a depth, for a target of " + name, "snippets.") +
            ";\n";
        out += "export const " + name + " = " + encoding_of_module(encoding) + ", write: " + write;
        encoding = {.direction = umbrage::depth_direction::reversed};
        out += ",\n    reversed: " + encoding_of_module(encoding) + ", write: " + write + " } };\n";
    });
    return out;
}

}  // namespace package
