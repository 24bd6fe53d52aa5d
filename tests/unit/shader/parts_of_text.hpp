// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/shader/glsl.hpp>

/// Number of times that a part occurs in a text.
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

/// The variables that a qualifier stands before, in order.
inline std::vector<std::string> qualified(std::string_view text, std::string_view qualifier) {
    std::vector<std::string> names;
    for (auto at = text.find(qualifier); at != text.npos; at = text.find(qualifier, at + qualifier.size())) {
        const std::string_view declaration = text.substr(at, text.find_first_of("=;(", at) - at);
        const auto end = declaration.find_last_not_of(' ') + 1, begin = declaration.rfind(' ', end - 1) + 1;
        names.emplace_back(declaration.substr(begin, end - begin));
    }
    return names;
}

/// The lines that the text of one snippet has behind its first; none in tier A.
inline std::string bounds_note(const umbrage::glsl::snippet& s, const std::string& may_reorder = "") {
    if (s.exactness == umbrage::glsl::tier::a) return "";
    const bool counts = s.within == 0.0f;
    return (may_reorder.empty() ? "" : "// " + may_reorder + " lets compilers fuse or reorder sums.\n") + "// " +
           std::string(s.name) + (s.exactness == umbrage::glsl::tier::b ? ", tier B: " : ", tier C: ") +
           umbrage::glsl::bound_in_words(s) + '\n' +
           (counts ? "// S is the formula with the magnitude of every value and a plus for every minus.\n"
                     "// Inside the bound, a comparison or floor may fall on either side.\n"
                   : "");
}

/// A text without its first line.
inline std::string_view second_line_on(std::string_view text) { return text.substr(text.find('\n') + 1); }
