// SPDX-License-Identifier: MIT
//
// Sentences of headers and pages, drawn by a seed for a reader to judge.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "pages.hpp"

namespace readme {

/// Sentences of comments and pages, each with its file, in an order that the seed alone decides.
/// @param count   largest number of sentences
[[nodiscard]] std::vector<std::string> sample_of(const std::vector<page>& all, const std::filesystem::path& root,
                                                 std::uint32_t seed, std::size_t count);

}  // namespace readme
