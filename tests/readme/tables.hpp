// SPDX-License-Identifier: MIT
//
// README.md's tables, from what the library knows of itself.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/shader/glsl.hpp>

namespace readme {

/// Snippets in a row of the registry that share a summary, such as encode_rg9 to encode_rg16.
struct family {
    std::vector<std::string_view> names;
    const umbrage::glsl::snippet* first;

    [[nodiscard]] std::string label() const;
};
[[nodiscard]] std::vector<family> families();

/// What stands between the page's marks, by their names.
[[nodiscard]] std::string primitives();
[[nodiscard]] std::string encodings();
[[nodiscard]] std::string filters();

/// The functions of a folder of headers that have no snippet: name, and the first sentence of the header's comment.
[[nodiscard]] std::string functions(const std::filesystem::path& folder);

}  // namespace readme
