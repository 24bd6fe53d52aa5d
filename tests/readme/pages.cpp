// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace readme {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

/// A page's lines with those of code and of generated sections empty, so that numbers of lines stay.
std::vector<std::string> prose_lines(const std::string& text) {
    std::vector<std::string> all = lines_of(text);
    bool code = false, generated = false;
    for (std::string& line : all) {
        const bool fence = line.find("```") == line.find_first_not_of(' ') && line.find("```") != line.npos;
        if (fence) code = !code;
        if (line.starts_with("<!-- begin: ")) generated = true;
        if (line.starts_with("<!-- end -->")) generated = false;
        if (code || generated || fence || line.starts_with("<!--") || line.starts_with("    ")) line.clear();
    }
    return all;
}

std::set<std::string> anchors(const page& p) {
    std::set<std::string> all;
    for (const std::string& line : prose_lines(p.text))
        if (line.starts_with('#')) all.insert(anchor(line.substr(line.find_first_not_of("# "))));
    return all;
}

struct place {
    std::size_t line;
    std::string text;
};

/// Paragraphs, list items and cells of tables, each as one text in words: code and links' targets are left out.
std::vector<place> texts_of(const page& p) {
    static const std::regex code("`[^`]*`"), link("!?\\[([^\\]]*)\\]\\([^)]*\\)"), mark("[*_|]{2,}|\\*");
    std::vector<place> all;
    bool open = false;
    const auto lines = prose_lines(p.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::string line = std::regex_replace(lines[i], code, "X");
        line = std::regex_replace(std::regex_replace(line, link, "$1"), mark, "");
        const bool item = std::regex_search(line, std::regex("^ *([-*]|[0-9]+\\.) "));
        if (line.empty() || line.starts_with('#')) open = false;
        else if (line.starts_with('|')) {
            std::istringstream cells(line);
            for (std::string cell; std::getline(cells, cell, '|');) all.push_back({i + 1, cell});
            open = false;
        } else if (open && !item) all.back().text += ' ' + line;
        else all.push_back({i + 1, line}), open = true;
    }
    return all;
}

/// Words to avoid, as the field has better ones.
const std::regex avoided(
    "\\b(lamps?|anew|besides|whence|abreast|look-ups?|set-ups?|foreign|swims?|crawls?|teeth|grain|half-shadows?|weighs|"
    "asks? for|is asked|are asked|tells?|told|in the manner of|hands? over|colour|centre|grey|"
    "ours|theirs|whole numbers?|whoever|whatever|stands still|pressed onto)\\b",
    std::regex::icase);

std::vector<std::string> wrong_words(const page& p) {
    std::vector<std::string> wrong;
    for (const place& t : texts_of(p)) {
        const std::string where = p.path + ':' + std::to_string(t.line) + ": ";
        std::smatch found;
        if (std::regex_search(t.text, found, avoided)) wrong.push_back(where + "the word '" + found.str() + "'");
        const std::regex end("[.!?:][)\"]?(?= |$)");
        for (std::sregex_token_iterator s(t.text.begin(), t.text.end(), end, -1), none; s != none; ++s) {
            std::istringstream words(*s);
            const auto count = std::distance(std::istream_iterator<std::string>(words), {});
            if (count > 25) wrong.push_back(where + std::to_string(count) + " words in a sentence: " + s->str());
        }
    }
    return wrong;
}

/// Title, first sentence, length without generated sections, languages of code.
std::vector<std::string> wrong_form(const page& p) {
    std::vector<std::string> wrong;
    const auto lines = lines_of(p.text);
    if (lines.size() < 3 || !lines[0].starts_with("# ") || !lines[1].empty() || lines[2].empty())
        wrong.push_back(p.path + ": no title with a sentence below it");
    const std::regex generated("<!-- begin: [^]*?<!-- end -->");
    const auto length = lines_of(std::regex_replace(p.text, generated, "")).size();
    const std::size_t most = p.path == "README.md" ? 200 : p.path.starts_with("include/") ? 120 : 250;
    if (length > most)
        wrong.push_back(p.path + ": " + std::to_string(length) + " lines, more than " + std::to_string(most));
    static const std::set<std::string> languages{"cpp",  "cpp not-run",  "glsl",  "html", "js",
                                                 "text", "text printed", "cmake", "sh"};
    bool open = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].starts_with("```")) continue;
        if (!open && !languages.contains(lines[i].substr(3)))
            wrong.push_back(p.path + ':' + std::to_string(i + 1) + ": no test knows code of the language '" +
                            lines[i].substr(3) + "'");
        open = !open;
    }
    return wrong;
}

}  // namespace

std::string anchor(const std::string& heading) {
    std::string out;
    for (const char c : heading)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-')
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ') out += '-';
    return out;
}

std::vector<std::string> prose_of(const page& p) {
    std::vector<std::string> all;
    for (const place& t : texts_of(p)) all.push_back(t.text);
    return all;
}

std::vector<page> pages(const fs::path& root) {
    std::vector<page> all;
    for (fs::recursive_directory_iterator i(root), end; i != end; ++i) {
        const std::string name = i->path().filename().string();
        if (i->is_directory() && (name.starts_with('.') || name.starts_with("build") || name == "node_modules"))
            i.disable_recursion_pending();
        if (i->path().extension() != ".md") continue;
        std::ifstream in(i->path());
        all.push_back({fs::relative(i->path(), root).generic_string(), {std::istreambuf_iterator<char>(in), {}}});
    }
    std::sort(all.begin(), all.end(), [](const page& a, const page& b) { return a.path < b.path; });
    if (all.size() < 10) throw std::runtime_error("few pages in " + root.string());
    return all;
}

std::vector<std::string> wrong_links(const std::vector<page>& all, const fs::path& root) {
    std::map<std::string, const page*> by_path;
    for (const page& p : all) by_path[p.path] = &p;
    std::vector<std::string> wrong;
    std::map<std::string, std::set<std::string>> links;
    static const std::regex link("\\]\\(([^)#]*)(#[^)]*)?\\)"), code("`[^`]*`");
    for (const page& p : all) {
        const auto lines = prose_lines(p.text);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string line = std::regex_replace(lines[i], code, "");
            for (std::sregex_iterator l(line.begin(), line.end(), link), end; l != end; ++l) {
                std::string to = (*l)[1], heading = (*l)[2];
                if (to.starts_with("http")) continue;
                to = to.empty() ? p.path : (fs::path(p.path).parent_path() / to).lexically_normal().generic_string();
                const auto target = by_path.find(to);
                const bool exists = target != by_path.end() || (to != "" && fs::exists(root / to));
                const bool found = heading.empty() ||
                                   (target != by_path.end() && anchors(*target->second).contains(heading.substr(1)));
                if (!exists || !found)
                    wrong.push_back(p.path + ':' + std::to_string(i + 1) + ": leads nowhere: " + l->str());
                links[p.path].insert(to);
            }
        }
    }
    std::set<std::string> reached{"README.md"};
    for (int step = 0; step < 2; ++step)
        for (const std::string& from : std::set<std::string>(reached))
            reached.insert(links[from].begin(), links[from].end());
    for (const page& p : all)
        if (!reached.contains(p.path)) wrong.push_back(p.path + ": more than two links from README.md");
    return wrong;
}

std::vector<std::string> wrong_prose(const std::vector<page>& all) {
    std::vector<std::string> wrong;
    for (const page& p : all) {
        if (p.path == "CHANGELOG.md" || p.path == "CONTRIBUTING.md" || p.path == "MUSEUM.md") continue;
        for (const auto& found : {wrong_form(p), wrong_words(p)}) wrong.insert(wrong.end(), found.begin(), found.end());
    }
    return wrong;
}

}  // namespace readme
