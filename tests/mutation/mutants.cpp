// SPDX-License-Identifier: MIT
#include "mutants.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace mutation {
namespace {

enum class what { number, word, sign, end };  // end: of the text or of a preprocessor line

struct token {
    what kind;
    std::size_t begin, end;
    std::string_view text;
};

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

/// Appends the tokens of `s` from `at` to `stop`.
void scan(std::string_view s, std::size_t at, std::size_t stop, std::vector<token>& out) {
    const auto add = [&](what kind, std::size_t end) {
        out.push_back({kind, at, end, s.substr(at, end - at)});
        at = end;
    };
    const auto from = [&](std::size_t i, auto belongs) {
        while (i < stop && belongs(s[i])) ++i;
        return i;
    };
    const auto in_word = [](char c) { return letter(c) || digit(c); };
    const auto line_end = [&] { return std::min(stop, s.find('\n', at)); };
    while (at < stop) {
        const char c = s[at];
        if (std::isspace(static_cast<unsigned char>(c))) {
            ++at;
        } else if (s.substr(at, 2) == "//") {
            at = line_end();
        } else if (c == '#') {
            const std::size_t end = line_end();
            at = from(at + 1, letter);
            const std::string_view directive = s.substr(s.rfind('#', at), at - s.rfind('#', at));
            if (directive == "#define") {  // its name and parameters are no sites
                at = from(from(at, [](char x) { return x == ' '; }), in_word);
                if (s[at] == '(') at = s.find(')', at) + 1;
            }
            if (directive == "#define" || directive == "#if") scan(s, at, end, out);
            at = end;
            add(what::end, end);
        } else if (letter(c)) {
            add(what::word, from(at, in_word));
        } else if (digit(c)) {
            std::size_t end = from(from(at, digit), [](char x) { return x == '.' || digit(x); });
            if (end + 1 < stop && s[end] == 'e') end = from(end + (s[end + 1] == '-' ? 2 : 1), digit);
            if (end < stop && s[end] == 'u') ++end;
            if (end < stop && in_word(s[end])) throw std::runtime_error("mutants: a number of another kind");
            add(what::number, end);
        } else {
            static constexpr std::array<std::string_view, 14> pairs{"<=", ">=", "==", "!=", "&&", "||", "<<",
                                                                    ">>", "+=", "-=", "*=", "/=", "++", "--"};
            add(what::sign, at + (std::find(pairs.begin(), pairs.end(), s.substr(at, 2)) != pairs.end() ? 2 : 1));
        }
    }
}

/// As GLSL: at least as many digits as tell floats apart, and a point.
std::string literal(float v) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.9g", static_cast<double>(v));
    std::string s = text.data();
    return s.find_first_of(".e") == std::string::npos ? s + ".0" : s;
}

std::string site(std::string_view source, std::size_t begin, std::size_t end, const std::string& becomes) {
    const std::size_t first = source.rfind('\n', begin) + 1, last = source.find('\n', end);
    std::string line(source.substr(first, begin - first));
    line += '[';
    line += source.substr(begin, end - begin);
    line += " -> ";
    line += becomes;
    line += ']';
    line += source.substr(end, last - end);
    line.resize(std::min(line.size(), line.find("  //")));
    for (const std::string_view qualifier : {"UMBRAGE_HIGHP ", "UMBRAGE_PRECISE "})
        for (std::size_t at; (at = line.find(qualifier)) != std::string::npos;) line.erase(at, qualifier.size());
    std::string plain;
    for (const char c : line)
        if (c != ' ' && c != '\n') plain += c;
        else if (!plain.empty() && plain.back() != ' ') plain += ' ';
    return plain;
}

class maker {
public:
    explicit maker(std::string_view source) : source_(source) {
        scan(source, 0, source.size(), tokens_);
        tokens_.push_back({what::end, source.size(), source.size(), ""});
        for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) visit(i);
    }
    std::vector<mutant> made;

private:
    void change(std::string_view kind, std::size_t begin, std::size_t end, std::string becomes) {
        std::string text(source_);
        text.replace(begin, end - begin, becomes);
        std::string where = site(source_, begin, end, becomes);
        if (const int n = ++seen_[std::string(kind) + where]; n > 1) where += " #" + std::to_string(n);
        made.push_back({kind, std::move(where), std::move(text)});
    }
    void change(std::string_view kind, const token& t, std::string becomes) {
        change(kind, t.begin, t.end, std::move(becomes));
    }

    [[nodiscard]] std::string_view at(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : ""; }
    [[nodiscard]] std::string text(std::size_t first, std::size_t end) const {
        return std::string(source_.substr(tokens_[first].begin, tokens_[end - 1].end - tokens_[first].begin));
    }

    /// The first token from i on that is one of `stops` outside of any parentheses that open after i.
    [[nodiscard]] std::size_t find(std::size_t i, std::initializer_list<std::string_view> stops) const {
        for (int depth = 0; tokens_[i].kind != what::end; ++i) {
            if (depth == 0 && std::find(stops.begin(), stops.end(), at(i)) != stops.end()) break;
            depth += at(i) == "(" || at(i) == "?" ? 1 : at(i) == ")" || at(i) == ":" ? -1 : 0;
        }
        return i;
    }

    /// Beginnings of the arguments after the parenthesis at `open`, and one past the end of the last.
    [[nodiscard]] std::vector<std::size_t> arguments(std::size_t open) const {
        std::vector<std::size_t> begins{open + 1};
        for (std::size_t i = find(open + 1, {",", ")"});; i = find(i + 1, {",", ")"})) {
            begins.push_back(i + 1);
            if (at(i) != ",") return begins;
        }
    }

    void visit(std::size_t i) {
        const token& t = tokens_[i];
        const std::string old(t.text);
        if (t.kind == what::number) {
            if (old.find('.') == std::string::npos) {
                const bool is_unsigned = old.back() == 'u';
                return change("unit", t, std::to_string(std::stoi(old) + 1) + (is_unsigned ? "u" : ""));
            }
            const float v = std::stof(old);
            const float next = v == 0.0f ? std::numeric_limits<float>::min() : std::nextafter(v, INFINITY);
            change("ulp", t, literal(next));
            return change("unit", t, literal(std::max(v + 1.0f, next)));
        }
        if (t.kind == what::word) return visit_word(i);
        if (t.text == "?") {
            const std::size_t colon = find(i + 1, {":"}), end = find(colon + 1, {",", ")", ";"});
            const std::string swapped = text(colon + 1, end) + " : " + text(i + 1, colon);
            return change("branches", tokens_[i + 1].begin, tokens_[end - 1].end, swapped);
        }
        static const std::map<std::string_view, std::vector<std::pair<std::string_view, std::string>>> flips{
            {"<", {{"boundary", "<="}, {"direction", ">"}}},
            {"<=", {{"boundary", "<"}, {"direction", ">="}}},
            {">", {{"boundary", ">="}, {"direction", "<"}}},
            {">=", {{"boundary", ">"}, {"direction", "<="}}},
            {"==", {{"boundary", "!="}}},
            {"!=", {{"boundary", "=="}}},
            {"+", {{"sign", "-"}}},
            {"-", {{"sign", "+"}}},
            {"+=", {{"sign", "-="}}},
            {"-=", {{"sign", "+="}}},
            {"!", {{"sign", ""}}},
            {"*", {{"arithmetic", "/"}}},
            {"/", {{"arithmetic", "*"}}},
            {"<<", {{"arithmetic", ">>"}}},
            {">>", {{"arithmetic", "<<"}}},
            {"&", {{"arithmetic", "|"}}},
            {"|", {{"arithmetic", "&"}}},
            {"&&", {{"arithmetic", "||"}}},
            {"||", {{"arithmetic", "&&"}}}};
        if (const auto found = flips.find(t.text); found != flips.end())
            for (const auto& [kind, becomes] : found->second) change(kind, t, becomes);
    }

    void visit_word(std::size_t i) {
        const token& t = tokens_[i];
        if (i > 0 && at(i - 1) == "." && t.text.size() == 1)
            for (const char c : {'x', 'y', 'z', 'w'})
                if (c != t.text[0]) change("channel", t, std::string(1, c));
        if (at(i + 1) != "(") return;
        static constexpr std::array<std::string_view, 8> dropped{
            "floor", "min", "max", "clamp", "abs", "sqrt", "umbrage_saturate", "umbrage_from_unorm"};
        const bool called = i == 0 || tokens_[i - 1].kind != what::word || at(i - 1) == "return";  // else it is defined
        if (called && std::find(dropped.begin(), dropped.end(), t.text) != dropped.end()) {
            const auto begins = arguments(i + 1);
            const std::string first = text(begins[0], begins[1] - 1);
            change("call", t.begin, tokens_[begins.back() - 1].end, std::string("(") + first + ")");
        }
        if (t.text == "vec2" || t.text == "vec3" || t.text == "vec4") {
            const auto begins = arguments(i + 1);
            for (std::size_t a = 0; a + 2 < begins.size(); ++a) {
                const std::string left = text(begins[a], begins[a + 1] - 1);
                const std::string right = text(begins[a + 1], begins[a + 2] - 1);
                if (left != right)
                    change("order", tokens_[begins[a]].begin, tokens_[begins[a + 2] - 2].end, right + ", " + left);
            }
        }
        if (t.text == "if") {
            const std::size_t statement = find(i + 2, {")"}) + 1;
            if (at(statement) != "{") change("statement", t.begin, tokens_[find(statement, {";"})].end, "");
        }
    }

    std::string_view source_;
    std::vector<token> tokens_;
    std::map<std::string, int> seen_;
};

}  // namespace

std::vector<mutant> mutants(std::string_view source) { return maker(source).made; }

}  // namespace mutation
