// SPDX-License-Identifier: MIT
//
// The pages' tables, from what the library knows of itself.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/shader/glsl.hpp>

#include "pages.hpp"

namespace readme {

/// Snippets in a row of the registry that share a summary, such as encode_rg9 to encode_rg16.
struct family {
    std::vector<std::string_view> names;
    const umbrage::glsl::snippet* first;

    [[nodiscard]] std::string label() const;
};
[[nodiscard]] std::vector<family> families();

/// The primitives that headers of some folders define.
/// @param include   the folder include/umbrage, which `folders` are relative to; folders below them do not count
[[nodiscard]] std::string primitives(const std::filesystem::path& include, const std::vector<std::string>& folders);

/// The names of headers that are no snippets, and the first sentence of each header's comment, which leads to it.
/// @param page   where the table stands
/// @param of     folders, or headers such as shader/bind.hpp
[[nodiscard]] std::string names(const std::filesystem::path& page, const std::filesystem::path& include,
                                const std::vector<std::string>& of);

/// What these headers' names are called elsewhere; each leads to the page of `pages` that lists its folder.
[[nodiscard]] std::string index(const std::vector<page>& pages, const std::filesystem::path& include,
                                const std::vector<std::string>& folders);

[[nodiscard]] std::string encodings();
[[nodiscard]] std::string filters();

/// The shadows that graphics APIs draw, and which of them: a row for each line of a list.
[[nodiscard]] std::string paths(const std::filesystem::path& list);

}  // namespace readme
