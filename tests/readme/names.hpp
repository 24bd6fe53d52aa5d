// SPDX-License-Identifier: MIT
//
// Public names and the pages that they stand on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pages.hpp"

namespace readme {

/// Names of headers that no page holds. A list excepts folders, headers and names, one a line. Its lines that except
/// nothing are wrong too, so that it has only what it needs.
[[nodiscard]] std::vector<std::string> wrong_names(const std::vector<page>& all, const std::filesystem::path& include,
                                                   const std::filesystem::path& list);

}  // namespace readme
