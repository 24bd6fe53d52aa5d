// SPDX-License-Identifier: MIT
#include "literals.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include "enumerations.hpp"

namespace turned {

namespace {

bool begins_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }
bool continues_word(char c) { return begins_word(c) || is_digit(c); }

class reader {
public:
    explicit reader(std::string_view code) : code_(code) {}

    std::vector<token> read() {
        while (at_ < code_.size()) {
            const char c = code_[at_];
            if (c == '\n') begins_line_ = true;
            if (std::isspace(static_cast<unsigned char>(c))) ++at_;
            else if (c == '#' && begins_line_) add(token_kind::directive, end_of_line());
            else if (starts("//")) add(token_kind::text, end_of_line());
            else if (starts("/*")) add(token_kind::text, after("*/", at_ + 2));
            else if (starts("R\"")) add(token_kind::text, end_of_raw());
            else if (c == '"' || c == '\'') add(token_kind::text, end_of_quoted(c));
            else if (begins_word(c)) add(token_kind::word, end_of_word());
            else if (is_digit(c) || (c == '.' && is_digit(at(at_ + 1)))) add(token_kind::number, end_of_number());
            else add(token_kind::sign, at_ + 1);
        }
        return std::move(tokens_);
    }

private:
    [[nodiscard]] char at(std::size_t i) const { return i < code_.size() ? code_[i] : '\0'; }
    [[nodiscard]] bool starts(std::string_view with) const { return code_.substr(at_).starts_with(with); }
    [[nodiscard]] std::size_t after(std::string_view end, std::size_t from) const {
        const std::size_t found = code_.find(end, from);
        if (found == code_.npos) throw std::runtime_error("code without the end " + std::string(end));
        return found + end.size();
    }
    [[nodiscard]] std::size_t end_of_line() const { return std::min(code_.find('\n', at_), code_.size()); }
    [[nodiscard]] std::size_t end_of_raw() const {
        const std::size_t open = code_.find('(', at_);
        return after(")" + std::string(code_.substr(at_ + 2, open - at_ - 2)) + "\"", open);
    }
    [[nodiscard]] std::size_t end_of_quoted(char quote) const {
        for (std::size_t i = at_ + 1; i < code_.size(); ++i) {
            if (code_[i] == '\\') ++i;
            else if (code_[i] == quote) return i + 1;
        }
        throw std::runtime_error("code with a string that does not end");
    }
    [[nodiscard]] std::size_t end_of_word() const {
        std::size_t i = at_;
        while (continues_word(at(i))) ++i;
        return i;
    }
    /// As the preprocessor reads a number: digits, letters, points, separators, and a sign behind an exponent.
    [[nodiscard]] std::size_t end_of_number() const {
        const bool is_hex = starts("0x") || starts("0X");
        std::size_t i = at_;
        for (;; ++i) {
            const char c = at(i), before = i > at_ ? char(std::tolower(static_cast<unsigned char>(at(i - 1)))) : '\0';
            const bool is_sign = (c == '+' || c == '-') && before == (is_hex ? 'p' : 'e');
            const bool separates = c == '\'' && continues_word(at(i + 1));
            if (!continues_word(c) && c != '.' && !is_sign && !separates) return i;
        }
    }
    void add(token_kind kind, std::size_t end) {
        tokens_.push_back({kind, at_, end - at_});
        at_ = end, begins_line_ = false;
    }

    std::string_view code_;
    std::size_t at_ = 0;
    bool begins_line_ = true;
    std::vector<token> tokens_;
};

/// What an open bracket holds.
struct bracket {
    char open;
    kept why;
};

class finder {
public:
    finder(std::string_view code, const std::vector<token>& tokens) : code_(code) {
        for (const token& t : tokens)
            if (t.kind != token_kind::text && t.kind != token_kind::directive) tokens_.push_back(t);
    }

    std::vector<literal> find() {
        std::vector<literal> all;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const token& t = tokens_[i];
            const std::string_view s = text(i);
            if (t.kind == token_kind::number) all.push_back({t.at, t.size, why()});
            else if (const auto others = others_of(i); !others.empty()) {
                const std::size_t from = tokens_[begin_of_name(i)].at;
                all.push_back({from, t.at + t.size - from, why(), others});
            } else if (s == "constexpr") constant_from_ = open_.size(), is_constant_ = true;
            else if (s == ";" && is_constant_ && open_.size() <= constant_from_) is_constant_ = false;
            else if (s == "<") i = end_of_arguments(i);
            else if (s == "(") open_.push_back({'(', i > 0 ? of_call(text(i - 1)) : kept::no});
            else if (s == "[") open_.push_back({'[', is_value(i) ? kept::in_subscript : kept::no});
            else if (s == "{") open_.push_back({'{', kept::no});
            else if ((s == ")" || s == "]" || s == "}") && !open_.empty()) open_.pop_back();
        }
        return all;
    }

private:
    [[nodiscard]] std::string_view text(std::size_t i) const { return code_.substr(tokens_[i].at, tokens_[i].size); }
    [[nodiscard]] static kept of_call(std::string_view called) {
        static constexpr std::array<std::string_view, 4> prints{"printf", "puts", "putchar", "write_picture"};
        if (called == "for") return kept::in_loop;
        return std::ranges::find(prints, called) != prints.end() ? kept::in_output : kept::no;
    }
    /// The first token of a name with its namespaces, by its last.
    [[nodiscard]] std::size_t begin_of_name(std::size_t i) const {
        while (i >= 3 && text(i - 1) == ":" && text(i - 2) == ":" && tokens_[i - 3].kind == token_kind::word) i -= 3;
        return i;
    }
    /// Names of the other values of the enumeration whose value ends here.
    [[nodiscard]] std::vector<std::string_view> others_of(std::size_t i) const {
        if (tokens_[i].kind != token_kind::word) return {};
        std::vector<std::string_view> all = names_of_values(begin_of_name(i) < i ? text(i - 3) : "", text(i));
        if (std::erase(all, text(i)) == 0) all.clear();
        return all;
    }
    /// True where a bracket follows a value, and not where it begins a lambda or an attribute.
    [[nodiscard]] bool is_value(std::size_t i) const {
        if (i == 0) return false;
        const std::string_view before = text(i - 1);
        return (tokens_[i - 1].kind == token_kind::word && before != "return") || before == ")" || before == "]";
    }
    /// The innermost bracket with a reason; braces within a loop's head or a call of printf are in it too.
    [[nodiscard]] kept why() const {
        if (is_constant_) return kept::in_constant;
        for (auto b = open_.rbegin(); b != open_.rend(); ++b)
            if (b->why != kept::no) return b->why;
        return kept::no;
    }
    /// The end of template arguments, which stand without a space behind a name; the sign itself where it compares.
    [[nodiscard]] std::size_t end_of_arguments(std::size_t i) const {
        const bool touches = i > 0 && tokens_[i - 1].kind == token_kind::word &&
                             tokens_[i - 1].at + tokens_[i - 1].size == tokens_[i].at && i + 1 < tokens_.size() &&
                             tokens_[i + 1].at == tokens_[i].at + 1;
        if (!touches) return i;
        int depth = 0;
        for (std::size_t k = i; k < tokens_.size(); ++k) {
            const std::string_view s = text(k);
            if (s == "<") ++depth;
            if (s == ">" && --depth == 0) return k;
            if (s == ";" || s == "{") break;
        }
        return i;
    }

    std::string_view code_;
    std::vector<token> tokens_;
    std::vector<bracket> open_;
    std::size_t constant_from_ = 0;
    bool is_constant_ = false;
};

}  // namespace

std::vector<token> tokens_of(std::string_view code) { return reader(code).read(); }

std::vector<literal> literals_of(std::string_view code, const std::vector<token>& tokens) {
    return finder(code, tokens).find();
}

std::vector<field> fields_of(std::string_view code, const std::vector<token>& tokens) {
    std::vector<token> all;
    for (const token& t : tokens)
        if (t.kind != token_kind::text && t.kind != token_kind::directive) all.push_back(t);
    const auto text = [&](std::size_t i) { return i < all.size() ? code.substr(all[i].at, all[i].size) : ""; };
    const auto end_of = [&](std::size_t i) { return all[i].at + all[i].size; };
    std::vector<field> found;
    bool is_constant = false;
    for (std::size_t i = 0; i + 2 < all.size(); ++i) {
        if (text(i) == "constexpr") is_constant = true;
        if (text(i) == ";") is_constant = false;
        const std::string_view before = i > 0 ? text(i - 1) : "";
        if (is_constant || text(i) != "." || text(i + 2) != "=" || (before != "{" && before != ",")) continue;
        std::size_t last = i + 2;
        for (int depth = 0; last < all.size(); ++last) {
            const std::string_view s = text(last);
            if (depth == 0 && (s == "," || s == "}")) break;
            if (s == "{" || s == "(" || s == "[") ++depth;
            if (s == "}" || s == ")" || s == "]") --depth;
        }
        const bool takes_next = text(last) == ",", takes_previous = !takes_next && before == ",";
        const std::size_t from = takes_previous ? all[i - 1].at : all[i].at;
        const std::size_t to = takes_next ? end_of(last) : all[last].at;
        found.push_back({from, to - from, end_of(i + 1) - all[i].at, all[i].at});
    }
    return found;
}

std::string_view name_of(kept why) {
    static constexpr std::array<std::string_view, 5> names{"turned", "loop", "subscript", "constant", "output"};
    return names[std::size_t(why)];
}

}  // namespace turned
