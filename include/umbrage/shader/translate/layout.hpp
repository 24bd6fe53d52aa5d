// SPDX-License-Identifier: MIT
//
// Where lines end, once words of another length stand in them.
//
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace umbrage::glsl::detail {

/// A statement over several lines, each at most 120 columns where a comma, a sum or a break of old allows it; what goes on
/// stands below the bracket that it is in, or four columns in.
class statement {
public:
    /// One more of its lines; the first one's indentation is the statement's.
    void append(std::string_view line) {
        const std::size_t code = line.find_first_not_of(' ');
        if (out_.empty()) indent_ = code, out_.assign(code, ' ');
        else if (out_.back() != '(') out_ += ' ';
        line.remove_prefix(code);
        while (!line.empty()) {
            const std::string_view piece = line.substr(0, end_of_piece(line));
            const std::size_t width = piece.size() - (piece.back() == ' ' ? 1 : 0);
            if (out_.size() > indent_ && out_.size() - begin_ + width > 120) break_line();
            out_ += piece;
            line.remove_prefix(piece.size());
        }
    }
    [[nodiscard]] const std::string& text() const { return out_; }

private:
    /// Behind the first comma or sum.
    [[nodiscard]] static std::size_t end_of_piece(std::string_view line) {
        const std::size_t comma = line.find(", "), plus = line.find(" + ");
        return comma < plus ? comma + 2 : (plus == line.npos ? plus : plus + 3);
    }

    void break_line() {
        while (out_.back() == ' ') out_.pop_back();
        std::size_t column = indent_ + 4, closed = 0;
        for (std::size_t i = out_.size(); i-- > 0;) {
            if (out_[i] == ')') ++closed;
            if (out_[i] != '(' || closed-- > 0) continue;
            column = i - out_.rfind('\n', i);  // one after the bracket
            break;
        }
        out_ += '\n';
        begin_ = out_.size();
        out_.append(column, ' ');
    }

    std::string out_;
    std::size_t indent_ = 0, begin_ = 0;  ///< `begin`: of the line at work
};

/// The text with the lines of each statement joined and broken again; a comment or a directive stays as it is.
[[nodiscard]] inline std::string laid_out(std::string_view text) {
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
            statement whole;
            whole.append(line);
            while (!ends_statement(line) && is_code(text.substr(0, text.find('\n')))) whole.append(line = next_line());
            out += whole.text();
        } else {
            out += line;
        }
        out += '\n';
    }
    return out;
}

}  // namespace umbrage::glsl::detail
