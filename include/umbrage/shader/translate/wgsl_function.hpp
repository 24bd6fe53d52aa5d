// SPDX-License-Identifier: MIT
//
// Translation of GLSL functions to WGSL, with their names, comments and layout.
//
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/shader/translate/wgsl_expression.hpp>

namespace umbrage::wgsl::detail {

/// Printer of a snippet's text: GLSL whose only preprocessor lines are about its version.
template <class = umbrage::detail::on_use>
class printer : expressions<> {
    struct head {
        std::string_view space;
        std::string gives, name;
        std::vector<variable> parameters;
    };

public:
    /// @param functions   functions that the text may call; its own are added
    printer(std::string_view text, signatures& functions) : expressions<>(text, functions), functions_(functions) {}

    /// Adds the signatures of the text's functions. If several share a name, their first type becomes a part of it.
    void declare() {
        std::vector<head> all;
        while (next().kind != piece::end) {
            if (next().kind == piece::comment || next().kind == piece::directive) {
                take();
                continue;
            }
            all.push_back(read_head());
            at = glsl::detail::closing(all_, at, "wgsl") + 1;
        }
        for (const head& h : all) {
            bool alone = true;
            for (const head& other : all) alone = alone && (&other == &h || other.name != h.name);
            const bool plain = alone || h.parameters.empty() || h.parameters[0].type == "float";
            signature s{h.name, h.name + (plain ? "" : "_" + name_of(h.parameters[0].type)), {}, h.gives};
            for (const variable& p : h.parameters) s.parameters += p.type + ',';
            functions_.push_back(std::move(s));
        }
    }

    /// Text in WGSL.
    /// @throws std::invalid_argument   a text outside the part of GLSL in which snippets are written
    [[nodiscard]] std::string print() {
        at = 0;
        while (next().kind != piece::end) {
            if (next().kind == piece::comment) comment();
            else function();
        }
        return out_ + std::string(next().space);
    }

private:
    void skip_qualifiers() {
        while (glsl::detail::is_qualifier(next().text)) take();
    }

    std::string read_type() {
        skip_qualifiers();
        const std::string type(take().text);
        if (!is_map(type)) static_cast<void>(name_of(type));
        return type;
    }

    std::string read_name() {
        if (next().kind != piece::word || glsl::detail::find_word(next().text))
            reject("no name: " + std::string(next().text));
        return std::string(take().text);
    }

    /// Head of a function, `float f(float a, ...)`. Its body follows.
    head read_head() {
        head h{next().space, read_type(), read_name(), {}};
        expect("(");
        while (!(next() == ")")) {
            if (!h.parameters.empty()) expect(",");
            std::string type = read_type();
            h.parameters.push_back({read_name(), std::move(type)});
        }
        expect(")");
        return h;
    }

    void comment() {
        const token& t = take();
        out_ += std::string(t.space) + std::string(t.text);
    }

    /// Indentation of the line being written.
    [[nodiscard]] std::size_t indentation() const {
        const std::size_t line = out_.rfind('\n') + 1, text = out_.find_first_not_of(' ', line);
        return (text == out_.npos ? out_.size() : text) - line;
    }

    void write(std::string_view space, std::string_view text) {
        out_ += space;
        out_ += text;
    }

    void function() {
        const head h = read_head();
        body_ = at;
        variables = h.parameters;
        std::string given, parameters, copies;
        for (const variable& p : h.parameters) {
            given += p.type + ',';
            if (!parameters.empty()) parameters += ", ";
            if (is_map(p.type)) {
                parameters += p.type + " " + p.name;
            } else {
                const bool copied = is_assigned(p.name);
                const std::string type = ": " + name_of(p.type), outer = p.name + (copied ? "_in" : "");
                parameters += outer + type;
                if (copied) copies += "\n    var " + p.name + type + " = " + outer + ";";
            }
        }
        const signature* const f = overload(h.name, given);
        write(h.space, "fn " + (f ? f->wgsl : "") + "(" + parameters + ") -> " + name_of(h.gives) + expect("{"));
        out_ += copies;
        block();
    }

    /// True when the function's body writes to the variable of that name.
    [[nodiscard]] bool is_assigned(std::string_view name) const {
        static constexpr std::string_view signs[]{"=", "+=", "-=", "*=", "/=", "|=", "&=", "++", "--"};
        const std::size_t end = glsl::detail::closing(all_, body_, "wgsl");
        for (std::size_t i = body_ + 1; i < end; ++i) {
            if (!(all_[i] == name) || glsl::detail::is_type(all_[i - 1].text)) continue;
            std::size_t behind = i + 1;
            while (all_[behind] == "." || all_[behind] == "[")
                behind = all_[behind] == "." ? behind + 2 : glsl::detail::closing(all_, behind, "wgsl") + 1;
            if (all_[i - 1] == "++" || all_[i - 1] == "--") return true;
            for (std::string_view sign : signs)
                if (all_[behind] == sign) return true;
        }
        return false;
    }

    /// Statements after an opening brace, and the closing one.
    void block() {
        while (!(next() == "}")) {
            if (next().kind == piece::end) reject("a brace is not closed");
            statement();
        }
        out_ += expect("}");
    }

    void statement() {
        const std::string_view space = next().space;
        if (next().kind == piece::comment) return comment();
        if (next() == "{") {
            out_ += expect("{");
            return block();
        }
        if (next() == "if" || next() == "for") {
            const std::string word(take().text);
            write(space, word + " " + (word == "if" ? condition() : loop()));
            body();
            if (word == "if" && next() == "else") alternative();
            return;
        }
        write(space, simple_statement());
        out_ += expect(";");
    }

    /// Declaration, assignment, or jump, up to its semicolon.
    std::string simple_statement() {
        skip_qualifiers();
        const std::string word(next().text);
        if (word == "return") {
            take();
            return word + spaced_expression().text;
        }
        if (word == "break" || word == "continue") {
            take();
            return word;
        }
        const bool constant = word == "const";
        if (constant) {
            take();
            skip_qualifiers();
        }
        if (glsl::detail::is_type(next().text)) return declaration(constant);
        if (next() == "++" || next() == "--") {  // WGSL has the sign after its variable
            const std::string sign(take().text);
            return expression().text + sign;
        }
        const value target = expression();
        const std::string sign = std::string(next().space) + std::string(next().text);
        if (next() == "++" || next() == "--") {
            take();
            return target.text + sign;
        }
        if (next().text.size() > 2 || !next().text.ends_with('=') || next() == "==")
            reject("not a statement: " + target.text + sign);
        take();
        return target.text + sign + spaced_expression().text;
    }

    std::string declaration(bool constant) {
        const std::string type = read_type();
        const std::string name = read_name();
        if (next() == "[") {
            expect("[");
            const std::string size = expression().text;
            expect("]");
            variables.push_back({name, type + "[" + size + "]"});
            return "var " + name + ": array<" + name_of(type) + ", " + size + ">";
        }
        const bool initialized = next() == "=";
        const bool changes = is_assigned(name) || !initialized;
        std::string text = std::string(constant ? "const " : changes ? "var " : "let ") + name + ": " + name_of(type);
        if (initialized) {
            text += expect("=");
            const value v = spaced_expression();
            if (v.type != type && !v.literal) reject(type + " " + name + " of " + v.type);
            text += v.text;
        }
        variables.push_back({name, type});
        return text;
    }

    std::string condition() {
        expect("(");
        const value v = spaced_expression();
        if (v.type != "bool") reject("if (" + v.text + ")");
        return "(" + v.text + expect(")");
    }

    std::string loop() {
        expect("(");
        std::string text = "(" + simple_statement();
        text += expect(";");
        text += spaced_expression().text;
        text += expect(";");
        text += next().space;
        text += simple_statement();
        return text += expect(")");
    }

    /// Body of `if`, `else` or `for`. WGSL requires braces.
    void body() {
        if (next() == "{") return statement();
        const std::size_t margin = indentation();
        const bool own_line = next().space.find('\n') != std::string_view::npos;
        out_ += " {";
        statement();
        out_ += own_line ? "\n" + std::string(margin, ' ') + "}" : " }";
    }

    void alternative() {
        out_ += expect("else");
        if (next() == "if") statement();
        else body();
    }

    signatures& functions_;
    std::string out_;
    std::size_t body_ = 0;  // opening brace of the function being printed
};

}  // namespace umbrage::wgsl::detail
