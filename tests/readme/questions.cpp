// SPDX-License-Identifier: MIT
#include "questions.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace readme {
namespace {

namespace fs = std::filesystem;

std::string trimmed(const std::string& text) {
    const auto begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
    return begin == text.npos ? "" : text.substr(begin, end + 1 - begin);
}

/// The text of a page, from a heading to the next of its rank where a link names one.
/// @param heading   "#5-shimmering", or empty
std::string section_of(const page& p, const std::string& heading) {
    if (heading.empty()) return p.text;
    std::istringstream in(p.text);
    std::string out;
    std::size_t rank = 0;
    for (std::string line; std::getline(in, line);) {
        const std::size_t level = line.starts_with('#') ? line.find(' ') : 0;
        if (rank != 0 && level != 0 && level <= rank) break;
        if (rank == 0 && level != 0 && '#' + anchor(line.substr(level + 1)) == heading) rank = level;
        if (rank != 0) out += line + '\n';
    }
    return out;
}

struct target {
    std::string path, heading;
};

/// Target of a page's link with these words. Its path is empty without such a link.
target follow(const page& from, const std::string& words) {
    const std::string link = '[' + words + "](";
    const auto at = from.text.find(link);
    if (at == from.text.npos) return {};
    const auto begin = at + link.size();
    const std::string to = from.text.substr(begin, from.text.find(')', begin) - begin);
    const std::string file = to.substr(0, to.find('#')), heading = to.substr(file.size());
    return {file.empty() ? from.path : (fs::path(from.path).parent_path() / file).lexically_normal().generic_string(),
            heading};
}

}  // namespace

std::vector<std::string> wrong_questions(const std::vector<page>& all, const fs::path& list) {
    std::ifstream in(list);
    std::vector<std::string> wrong;
    int asked = 0;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        ++asked;
        const auto first = line.find('|'), second = line.find('|', first + 1);
        if (first == line.npos || second == line.npos) throw std::runtime_error("no question: " + line);
        const std::string question = trimmed(line.substr(0, first)), answer = trimmed(line.substr(second + 1));
        std::istringstream links(line.substr(first + 1, second - first - 1));
        target at{"README.md", ""};
        int clicks = 0;
        const auto page_at = [&] {
            for (const page& p : all)
                if (p.path == at.path) return p;
            throw std::runtime_error(question + " leads to no page: " + at.path);
        };
        for (std::string words; std::getline(links, words, '>'); ++clicks) {
            at = follow(page_at(), trimmed(words));
            if (at.path.empty()) break;
        }
        if (at.path.empty()) wrong.push_back(question + " No link of these words: " + line);
        else if (section_of(page_at(), at.heading).find(answer) == std::string::npos)
            wrong.push_back(question + " No answer at " + at.path + at.heading + ": " + answer);
        if (clicks > 2) wrong.push_back(question + " More than two clicks.");
    }
    if (asked < 10) throw std::runtime_error("few questions in " + list.string());
    return wrong;
}

}  // namespace readme
