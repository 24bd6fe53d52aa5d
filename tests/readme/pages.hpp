// SPDX-License-Identifier: MIT
//
// The project's pages, and the rules that a program can hold them to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace readme {

struct page {
    std::string path;  ///< relative to the root, with slashes
    std::string text;
};

/// Every Markdown file of the project, in the order of the paths; none of build folders or hidden ones.
[[nodiscard]] std::vector<page> pages(const std::filesystem::path& root);

/// Anchor that GitHub makes of a heading.
[[nodiscard]] std::string anchor(const std::string& heading);

/// Paragraphs, items and cells of a page, in words: code and links' targets are left out.
[[nodiscard]] std::vector<std::string> prose_of(const page& p);

/// Relative links to files or headings that do not exist, and pages that are more than two links from README.md.
[[nodiscard]] std::vector<std::string> wrong_links(const std::vector<page>& all, const std::filesystem::path& root);

/// Sentences of more than 25 words, words that the field does not use, pages that are too long or do not begin with a
/// title and a sentence, code in an unknown language. Change logs, contributors' and generated pages are left out.
[[nodiscard]] std::vector<std::string> wrong_prose(const std::vector<page>& all);

}  // namespace readme
