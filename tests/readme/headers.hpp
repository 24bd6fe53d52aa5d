// SPDX-License-Identifier: MIT
//
// The library's headers as text: their names and what their first comments say.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace readme {

/// Headers' texts by their places in `include`, less primitives.hpp, which is generated.
[[nodiscard]] const std::map<std::string, std::string>& headers(const std::filesystem::path& include);

[[nodiscard]] std::string folder_of(const std::string& place);

/// The first sentence of the comment that a header opens with.
[[nodiscard]] std::string opening_sentence(const std::string& header);

/// Functions, then types, concepts and constants, at the beginning of a line outside namespace detail, each once.
[[nodiscard]] std::vector<std::string> names_in(const std::string& header);

/// Names from elsewhere, and those that stand for them here.
struct also_called {
    std::string elsewhere;
    std::vector<std::string> here;
};

/// What a first comment says after "Also called:", one of each semicolon's parts. A part ends with the names in
/// parentheses. Without them it is the function of the header's own name, or else all of at most three functions.
/// @throws std::runtime_error   a name that the header lacks
[[nodiscard]] std::vector<also_called> also_called_in(const std::string& place, const std::string& header);

}  // namespace readme
