// SPDX-License-Identifier: MIT
#include "sample.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <regex>
#include <sstream>
#include <utility>

namespace readme {
namespace {

namespace fs = std::filesystem;

/// Comments of a header: each a text of its lines; a tag, a list's item and a member's comment begin another.
std::vector<std::string> comments_of(const std::string& header) {
    static const std::regex comment("^(.*?)//[/!]?<?( ?)(.*)$"), code("^(    |@|-|\\|)");
    std::vector<std::string> all;
    std::istringstream in(header);
    bool open = false, raw = false;
    for (std::string line; std::getline(in, line);) {
        if (line.find("R\"GLSL(") != line.npos) raw = true;
        std::smatch found;
        const bool is_comment = !raw && std::regex_match(line, found, comment) && line.find("\"") == line.npos;
        if (line.find(")GLSL\"") != line.npos) raw = false;
        if (!is_comment || found[3].str().empty() || found[3].str().starts_with("SPDX") ||
            found[3].str().starts_with("    ")) {
            open = false;
            continue;
        }
        const bool alone = std::regex_match(found[1].str(), std::regex("\\s*"));
        std::string text = std::regex_replace(found[3].str(),
                                              std::regex("^@(param|tparam|return|throws|edge|formula|"
                                                         "exactness|accuracy|cite|detaches)\\s+"),
                                              "");
        if (found[3].str().starts_with("@param") || found[3].str().starts_with("@tparam"))
            text = std::regex_replace(text, std::regex("^[a-z_0-9, A-Z]+?   *"), "");
        if (open && alone && !std::regex_search(found[3].str(), code)) all.back() += ' ' + text;
        else all.push_back(text);
        open = alone;
    }
    return all;
}

}  // namespace

std::vector<std::string> sample_of(const std::vector<page>& all, const fs::path& root, std::uint32_t seed,
                                   std::size_t count) {
    std::vector<std::pair<std::string, std::string>> texts;  // file, text
    for (const page& p : all)
        for (const std::string& text : prose_of(p)) texts.emplace_back(p.path, text);
    std::vector<fs::path> headers;
    for (const auto& entry : fs::recursive_directory_iterator(root / "include/umbrage"))
        if (entry.path().extension() == ".hpp") headers.push_back(entry.path());
    std::sort(headers.begin(), headers.end());
    for (const fs::path& path : headers) {
        std::ifstream in(path);
        for (std::string& text : comments_of({std::istreambuf_iterator<char>(in), {}}))
            texts.emplace_back(fs::relative(path, root).generic_string(), std::move(text));
    }
    static const std::regex end("[.!?](?= |$)");
    std::vector<std::string> sentences;
    for (const auto& [file, text] : texts)
        for (std::sregex_token_iterator s(text.begin(), text.end(), end, -1), none; s != none; ++s) {
            std::istringstream words(*s);
            if (std::distance(std::istream_iterator<std::string>(words), {}) >= 4)
                sentences.push_back(file + ": " + s->str());
        }
    std::mt19937 random(seed);
    for (std::size_t i = sentences.size(); i > 1; --i) std::swap(sentences[i - 1], sentences[random() % i]);
    sentences.resize(std::min(count, sentences.size()));
    return sentences;
}

}  // namespace readme
