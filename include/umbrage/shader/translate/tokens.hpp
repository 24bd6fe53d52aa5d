// SPDX-License-Identifier: MIT
//
// Tokens of GLSL text, for printing it in other languages. Nothing is lost: space and text of all tokens, in a row, are
// the original text.
//
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>

namespace umbrage::glsl::detail {

enum class piece { word, number, sign, comment, directive, end };

struct token {
    piece kind = piece::end;
    std::string_view space;  ///< white space before the token
    std::string_view text;   ///< for a comment or a directive the rest of the line, without its end

    [[nodiscard]] bool operator==(std::string_view other) const { return text == other; }
};

[[nodiscard]] constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Longest sign that `text` begins with; empty if there is none.
[[nodiscard]] inline std::string_view sign_at(std::string_view text) {
    static constexpr std::string_view two[]{"++", "--", "<=", ">=", "==", "!=", "&&", "||",
                                            "<<", ">>", "+=", "-=", "*=", "/=", "|=", "&="};
    for (std::string_view sign : two)
        if (text.starts_with(sign)) return text.substr(0, 2);
    static constexpr std::string_view one = "+-*/%<>=!&|^~?:;,.()[]{}";
    return one.find(text.front()) == one.npos ? std::string_view() : text.substr(0, 1);
}

/// End of the number that begins at text[i].
[[nodiscard]] inline std::size_t end_of_number(std::string_view text, std::size_t i) {
    const bool hexadecimal = text.substr(i, 2) == "0x";
    for (char last = '0'; i < text.size(); last = text[i++]) {
        const bool of_exponent = !hexadecimal && (last == 'e' || last == 'E') && (text[i] == '+' || text[i] == '-');
        if (!is_letter(text[i]) && !is_digit(text[i]) && text[i] != '.' && !of_exponent) break;
    }
    return i;
}

/// Tokens of `text`, which must outlive them. The last is an end, with the remaining space.
/// @throws std::invalid_argument   a character that GLSL does not have
template <class = umbrage::detail::on_use>
[[nodiscard]] std::vector<token> tokens(std::string_view text, std::string_view language = "glsl") {
    std::vector<token> all;
    for (std::size_t i = 0;;) {
        const std::size_t from = i;
        while (i < text.size() && (text[i] == ' ' || text[i] == '\n')) ++i;
        const std::size_t at = i;
        token t{piece::end, text.substr(from, at - from), {}};
        if (at < text.size()) {
            const std::string_view rest = text.substr(at);
            if (rest.starts_with("//") || rest[0] == '#') {
                t.kind = rest[0] == '#' ? piece::directive : piece::comment;
                i = text.find('\n', at) == text.npos ? text.size() : text.find('\n', at);
            } else if (is_letter(rest[0])) {
                t.kind = piece::word;
                while (i < text.size() && (is_letter(text[i]) || is_digit(text[i]))) ++i;
            } else if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) {
                t.kind = piece::number;
                i = end_of_number(text, at);
            } else {
                t.kind = piece::sign;
                i += sign_at(rest).size();
                if (i == at)
                    umbrage::detail::refuse(std::string(language) + "::text", "source", "of characters of GLSL",
                                            rest.substr(0, 1));
            }
            t.text = text.substr(at, i - at);
        }
        all.push_back(t);
        if (t.kind == piece::end) return all;
    }
}

/// Tokens before the #else of "#if __VERSION__ >= ...", for languages that have all of the newest GLSL.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::vector<token> newest(std::vector<token> all) {
    enum { outside, before, behind } place = outside;  // relative to #else
    std::erase_if(all, [&](const token& t) {
        if (t.kind != piece::directive) return place == behind;
        if (t.text.starts_with("#if __VERSION__ >= ")) place = before;
        else if (place == outside) return false;
        else place = t == "#else" ? behind : outside;
        return true;
    });
    return all;
}

/// Index of the bracket that closes the one at all[i].
/// @throws std::invalid_argument   no such bracket
template <class = umbrage::detail::on_use>
[[nodiscard]] std::size_t closing(const std::vector<token>& all, std::size_t i, std::string_view language = "glsl") {
    std::size_t depth = 0;
    for (std::size_t k = i; k < all.size(); ++k) {
        if (all[k].kind != piece::sign) continue;
        const char c = all[k].text[0];
        if (c == '(' || c == '[' || c == '{') ++depth;
        if ((c == ')' || c == ']' || c == '}') && --depth == 0) return k;
    }
    umbrage::detail::refuse(std::string(language) + "::text", "source", "of brackets in pairs", all[i].text,
                            "Nothing closes it.");
}

}  // namespace umbrage::glsl::detail
