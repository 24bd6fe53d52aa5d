// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// How often a part occurs in a text.
inline std::size_t count(std::string_view text, std::string_view part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++n;
    return n;
}

/// The text of one function, with the comment that explains it.
inline std::string function_with_comment(const std::string& text, const std::string& name) {
    const auto begin = text.find("\n// " + name + ":") + 1;
    return text.substr(begin, text.find("\n}\n", begin) + 3 - begin);
}
