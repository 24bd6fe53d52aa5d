// SPDX-License-Identifier: MIT
//
// Tokens of C++ code, as far as it takes to find its numbers and enumerators, and to see which of them may change while
// a program runs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace turned {

enum class token_kind { word, number, sign, text, directive };  ///< text: strings, characters and comments

struct token {
    token_kind kind;
    std::size_t at, size;
};

/// Tokens of code, without its white space.
/// @throws std::runtime_error   a comment or string that does not end
[[nodiscard]] std::vector<token> tokens_of(std::string_view code);

/// Why a number keeps its value.
enum class kept { no, in_loop, in_subscript, in_constant, in_output };

struct literal {
    std::size_t at, size;
    kept why;
    std::vector<std::string_view> others{};  ///< names of an enumerator's other values; a number has none
};

/// Numbers and enumerators of code in their order, without template arguments, which are other programs.
[[nodiscard]] std::vector<literal> literals_of(std::string_view code, const std::vector<token>& tokens);

[[nodiscard]] std::string_view name_of(kept why);

/// A designated initializer, `.name = value`, with the comma that separates it.
struct field {
    std::size_t at, size;   ///< of what is left out
    std::size_t name_size;  ///< of `.name`, which `name_at` begins
    std::size_t name_at;
};

/// Designated initializers of code in their order, without those of constants, which a compiler may refuse to change.
[[nodiscard]] std::vector<field> fields_of(std::string_view code, const std::vector<token>& tokens);

}  // namespace turned
