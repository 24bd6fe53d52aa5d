// SPDX-License-Identifier: MIT
//
// Questions that people come with, and the way from README.md to their answers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pages.hpp"

namespace readme {

/// Questions of a list whose links do not exist, whose answer does not stand where they lead, or that take more than
/// two clicks.
/// @param list   a question a line, see questions.txt
[[nodiscard]] std::vector<std::string> wrong_questions(const std::vector<page>& all, const std::filesystem::path& list);

}  // namespace readme
