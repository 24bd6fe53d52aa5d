// SPDX-License-Identifier: MIT
#include "headers.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace readme {
namespace {

namespace fs = std::filesystem;

/// The lines of the first comment below the license, an empty one as a line of its own.
std::string first_comment(const std::string& header) {
    std::istringstream in(header);
    std::string words, line;
    std::getline(in, line);
    while (std::getline(in, line) && line.starts_with("//")) words += line == "//" ? "\n" : line.substr(3) + ' ';
    return words;
}

/// A sentence's length, from its begin; npos where it has no end.
std::size_t sentence_end(const std::string& text, std::size_t begin) {
    for (std::size_t i = begin + 1; i < text.size(); ++i)
        if (text[i] == '.' && (i + 1 == text.size() || std::isspace(static_cast<unsigned char>(text[i + 1]))) &&
            (std::isalnum(static_cast<unsigned char>(text[i - 1])) || text[i - 1] == ')' || text[i - 1] == ']'))
            return i;
    return text.npos;
}

std::vector<std::string> parts(const std::string& text, char mark) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, mark);) all.push_back(part.substr(part.find_first_not_of(' ')));
    return all;
}

void add_each(std::vector<std::string>& names, const std::string& text, const std::regex& declaration) {
    for (std::sregex_iterator i(text.begin(), text.end(), declaration), end; i != end; ++i)
        if (std::find(names.begin(), names.end(), (*i)[1]) == names.end()) names.push_back((*i)[1]);
}

std::string without_detail(const std::string& header) {
    std::istringstream in(header);
    std::string users;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        inside = inside || (line.starts_with("namespace ") && line.ends_with("detail {"));
        if (!inside) users += line + '\n';
        inside = inside && !(line.starts_with("}  // namespace ") && line.ends_with("detail"));
    }
    return users;
}

std::vector<std::string> functions_in(const std::string& header) {
    static const std::regex function(
        "(?:^|\n)(?:requires\\([^)]*\\)\\s*)?(?:\\[\\[nodiscard\\]\\] )?(?:inline |constexpr )*[a-zA-Z_:][\\w:<>, +]* "
        "(\\w+)\\(");
    std::vector<std::string> names;
    add_each(names, without_detail(header), function);
    std::erase_if(names, [](const std::string& name) { return name.starts_with("umbrage_"); });  // of snippets
    return names;
}

}  // namespace

const std::map<std::string, std::string>& headers(const fs::path& include) {
    static const auto all = [&] {
        std::map<std::string, std::string> texts;
        for (const auto& file : fs::recursive_directory_iterator(include)) {
            if (file.path().extension() != ".hpp" || file.path().filename() == "primitives.hpp") continue;
            std::ifstream in(file.path());
            texts[fs::relative(file.path(), include).generic_string()] = {std::istreambuf_iterator<char>(in), {}};
        }
        return texts;
    }();
    return all;
}

std::string folder_of(const std::string& place) { return fs::path(place).parent_path().generic_string(); }

std::string opening_sentence(const std::string& header) {
    std::string words = first_comment(header);
    words.erase(0, words.find_first_not_of('\n'));
    const auto end = sentence_end(words, 0);
    if (end == words.npos || words.find('\n') < end)
        throw std::runtime_error("no header comment with a sentence: " + header.substr(0, 200));
    return words.substr(0, end);
}

std::vector<std::string> names_in(const std::string& header) {
    // A type that is declared without its members is another header's.
    static const std::regex type("\n(?:struct|class|enum class|concept|using) (?:\\[\\[\\w+\\]\\] )?(\\w+)[^\\w;]"),
        constant("\ninline constexpr [\\w:<>, *]+?[ *](\\w+)(?:\\{| =|;)");
    std::vector<std::string> names = functions_in(header);
    const std::string users = without_detail(header);
    add_each(names, users, type);
    add_each(names, users, constant);
    return names;
}

std::vector<also_called> also_called_in(const std::string& place, const std::string& header) {
    static const std::regex named("(.*) \\(([a-z]\\w*(?:, [a-z]\\w*)*)\\)");
    const std::string comment = first_comment(header), sign = "Also called: ";
    const auto begin = comment.find(sign);
    if (begin == comment.npos) return {};
    const auto words = begin + sign.size();
    const std::string code = header.substr(header.find("#pragma once"));
    std::vector<also_called> all;
    for (const std::string& part : parts(comment.substr(words, sentence_end(comment, words) - words), ';')) {
        std::smatch found;
        if (std::regex_match(part, found, named)) all.push_back({found[1], parts(found[2], ',')});
        else {
            const std::string stem = fs::path(place).stem().string();
            const std::vector<std::string> functions = functions_in(header);
            const bool own = std::find(functions.begin(), functions.end(), stem) != functions.end();
            all.push_back({part, own ? std::vector{stem} : functions});
            if (all.back().here.empty() || all.back().here.size() > 3)
                throw std::runtime_error(place + ": name in parentheses what is also called '" + part + "'");
        }
        for (const std::string& name : all.back().here)
            if (!std::regex_search(code, std::regex("\\b" + name + "\\b")))
                throw std::runtime_error(place + " has no '" + name + "', which it says is also called '" + part + "'");
    }
    return all;
}

}  // namespace readme
