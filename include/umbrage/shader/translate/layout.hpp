// SPDX-License-Identifier: MIT
//
// Line breaks of translated text, whose words have other lengths.
//
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/core/config.hpp>

namespace umbrage::glsl::detail {

/// One statement, or a function's head, in lines of at most 120 columns. Lines break after a comma or an operator, as
/// far out of brackets as possible. The next line is indented to its bracket, or by four columns.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string broken(std::string statement) {
    const std::size_t margin = statement.find_first_not_of(' ');
    std::string out;
    std::vector<std::size_t> brackets;  // columns after the brackets that are open at the start of the line
    for (std::size_t begin = margin; statement.size() > 120;) {
        std::vector<std::size_t> open = brackets, open_at_end;
        std::size_t end = 0;
        for (std::size_t i = begin; i <= 120; ++i) {
            const char c = statement[i];
            if (c == '(' || c == '[') open.push_back(i + 1);
            if ((c == ')' || c == ']') && !open.empty()) open.pop_back();
            const bool can_end =
                c == ' ' && i > begin && std::string_view(",=+*/&|").find(statement[i - 1]) != std::string_view::npos;
            if (!can_end || (end > 0 && open.size() > open_at_end.size())) continue;
            end = i;
            open_at_end = open;
        }
        if (end == 0) break;
        brackets = open_at_end;
        begin = brackets.empty() ? margin + 4 : brackets.back();
        out += statement.substr(0, end) + '\n';
        statement.replace(0, end + 1, begin, ' ');
    }
    return out + statement;
}

/// Text with the lines of each statement joined and broken again. Comments and directives stay as they are.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string laid_out(std::string_view text) {
    const auto next_line = [&] {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(line.size() < text.size() ? line.size() + 1 : line.size());
        return line;
    };
    const auto is_code = [](std::string_view line) {
        const std::size_t begin = line.find_first_not_of(' ');
        return begin != line.npos && line[begin] != '#' && line.substr(begin, 2) != "//";
    };
    const auto ends_statement = [](std::string_view line) {
        return line.find("//") != line.npos || std::string_view(";{}").find(line.back()) != std::string_view::npos;
    };
    std::string out;
    while (!text.empty()) {
        std::string_view line = next_line();
        if (is_code(line)) {
            std::string statement(line.substr(0, line.find("//")));
            while (!ends_statement(line) && is_code(text.substr(0, text.find('\n')))) {
                line = next_line();
                std::string_view code = line.substr(0, line.find("//"));
                code.remove_prefix(code.find_first_not_of(' '));
                statement += (statement.back() == '(' ? "" : " ") + std::string(code);
            }
            out += broken(std::move(statement));
            if (line.find("//") != line.npos) out += line.substr(line.find("//"));
        } else {
            out += line;
        }
        out += '\n';
    }
    return out;
}

}  // namespace umbrage::glsl::detail
