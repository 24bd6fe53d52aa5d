// SPDX-License-Identifier: MIT
//
// Translation word by word to HLSL and MSL, which are close enough to GLSL for that.
//
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/shader/translate/layout.hpp>
#include <umbrage/shader/translate/tokens.hpp>
#include <umbrage/shader/translate/words.hpp>

namespace umbrage::glsl::detail {

/// Differences of a language like GLSL from it.
struct near_language {
    std::string_view name;
    std::string_view word::*own;
    std::string_view precise;      ///< word for UMBRAGE_PRECISE; empty: nothing
    std::string_view function;     ///< word before each function's type,
    std::string_view condition;    ///< and before the type of a function that returns bool
    bool matrices_have_rows;       ///< matrices are made of rows, and indexed by row
    bool vectors_of_one_are_cast;  ///< vec4(x) is (float4)x
    std::string_view reserved;     ///< words that GLSL may use for a variable, and this language may not: " a b "
};

/// Printer of functions in a language like GLSL.
template <class = umbrage::detail::on_use>
class word_by_word {
public:
    word_by_word(const near_language& language, std::string_view text)
        : language_(language), all_(newest(tokens(text, language.name))) {}

    [[nodiscard]] std::string print() {
        std::string out = print(0, all_.size() - 1);
        return out += all_.back().space;
    }

private:
    [[nodiscard]] std::string print(std::size_t from, std::size_t to) {
        std::string out;
        for (std::size_t i = from; i < to;) {
            const token& t = all_[i];
            if (t == "{") ++depth_;
            if (t == "}") --depth_;
            if (t == "*") refuse_matrix(i);
            out += t.space;
            switch (t.kind) {
                case piece::word: i = print_word(out, i); break;
                case piece::directive: unknown(language_.name, t.text);
                default: out += t.text, ++i;
            }
        }
        return out;
    }

    /// Prints one word.
    /// @return   index of the token that follows
    std::size_t print_word(std::string& out, std::size_t i) {
        const std::string_view text = all_[i].text;
        if (is_qualifier(text)) {
            const std::string_view kept = text == "UMBRAGE_PRECISE" ? language_.precise : "";
            out += kept;
            if (kept.empty()) all_[i + 1].space = {};
            return i + 1;
        }
        const word* w = find_word(text);
        if (w && w->kind == word_kind::type) return print_type(out, i, w->*language_.own);
        if (w) {
            if (w->kind == word_kind::function && !(all_[i + 1] == "(")) unknown(language_.name, text);
            out += w->*language_.own;
            return i + 1;
        }
        if (i > 0 && all_[i - 1] == ".") {
            if (text.find_first_not_of("xyzw") != text.npos) unknown(language_.name, text);
            out += text;
            return i + 1;
        }
        if (all_[i + 1] == "(" && text.starts_with("umbrage_")) {
            out += text;
            return i + 1;
        }
        if (text == "UMBRAGE_MAP") return print_type(out, i, text);
        const std::string_view type = type_of(text);
        if (type.empty() && find_map_word(text) == nullptr) unknown(language_.name, text);
        const bool column = all_[i + 1] == "[" && is_matrix(type) && language_.matrices_have_rows;
        out += column ? "transpose(" + std::string(text) + ")" : std::string(text);
        return i + 1;
    }

    /// Prints the type of a function or variable, or a constructor.
    std::size_t print_type(std::string& out, std::size_t i, std::string_view own) {
        if (all_[i + 1] == "(") return print_constructor(out, i, own);
        if (all_[i + 1].kind != piece::word) unknown(language_.name, all_[i + 1].text);
        const std::string_view name = all_[i + 1].text;
        const bool function = all_[i + 2] == "(";
        if (function && depth_ == 0) {
            variables_.clear();
            out += language_.function;
            if (all_[i] == "bool") out += language_.condition;
        } else {
            if (language_.reserved.find(' ' + std::string(name) + ' ') != name.npos) unknown(language_.name, name);
            variables_.push_back({name, all_[i].text});
        }
        out += own;
        out += all_[i + 1].space;
        out += name;
        return i + 2;
    }

    std::size_t print_constructor(std::string& out, std::size_t i, std::string_view own) {
        const std::string_view type = all_[i].text;
        const std::size_t end = closing(all_, i + 1, language_.name);
        const std::string arguments = print(i + 2, end);
        const std::size_t count = arguments_in(i + 1, end);
        if (is_matrix(type) && count == 1) unknown(language_.name, std::string(type) + " of one");
        std::string made = std::string(own) + "(" + arguments + ")";
        if (is_matrix(type) && language_.matrices_have_rows) made = "transpose(" + made + ")";
        if (is_vector(type) && count == 1 && language_.vectors_of_one_are_cast) {
            made = "(" + std::string(own) + ")" + (is_operand(i + 2, end) ? arguments : "(" + arguments + ")");
            if (all_[end + 1] == "." || all_[end + 1] == "[") made = "(" + made + ")";
        }
        out += made;
        return end + 1;
    }

    [[nodiscard]] std::size_t arguments_in(std::size_t open, std::size_t end) const {
        std::size_t count = 1;
        for (std::size_t i = open + 1; i < end; ++i) {
            if (all_[i] == "(" || all_[i] == "[") i = closing(all_, i, language_.name);
            if (all_[i] == ",") ++count;
        }
        return count;
    }

    /// True for a name, a number, a call or a component of those: a cast needs no brackets around it.
    [[nodiscard]] bool is_operand(std::size_t from, std::size_t to) const {
        for (std::size_t i = from; i < to; ++i) {
            if (all_[i] == "(" || all_[i] == "[") i = closing(all_, i, language_.name);
            else if (all_[i].kind == piece::sign && !(all_[i] == ".")) return false;
        }
        return true;
    }

    /// Refuses a product with a matrix, which depends on rows and columns. Snippets write the columns out.
    void refuse_matrix(std::size_t i) const {
        for (const token* t : {&all_[i > 0 ? i - 1 : 0], &all_[i + 1]})
            if (is_matrix(type_of(t->text)) && !(all_[i + 2] == "["))
                unknown(language_.name, "a matrix times something");
    }

    [[nodiscard]] std::string_view type_of(std::string_view name) const {
        for (const variable& v : variables_)
            if (v.name == name) return v.type;
        return {};
    }
    [[nodiscard]] static bool is_matrix(std::string_view type) { return type.starts_with("mat"); }
    [[nodiscard]] static bool is_vector(std::string_view type) {
        return type.find("vec") != type.npos;  // ivec2 too
    }

    struct variable {
        std::string_view name, type;  ///< in GLSL
    };

    const near_language& language_;
    std::vector<token> all_;
    std::vector<variable> variables_;
    std::size_t depth_ = 0;
};

}  // namespace umbrage::glsl::detail
