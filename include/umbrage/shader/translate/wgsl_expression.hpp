// SPDX-License-Identifier: MIT
//
// Translation of GLSL expressions to WGSL. WGSL converts nothing, so conversions and the chosen overload of a function
// are written out.
//
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/shader/translate/tokens.hpp>
#include <umbrage/shader/translate/types.hpp>
#include <umbrage/shader/translate/words.hpp>

namespace umbrage::wgsl::detail {

using glsl::detail::piece;
using glsl::detail::token;

/// Function of the text: one overload.
struct signature {
    std::string name, wgsl;  ///< WGSL has no overloads
    std::string parameters;  ///< types of the parameters, a comma after each
    std::string gives;
};
using signatures = std::vector<signature>;

struct variable {
    std::string name, type;
};

struct value {
    std::string text, type;
    int level;             ///< level of its outermost operator; the highest if it needs no brackets
    bool literal = false;  ///< a number, which takes its type from its context
    bool select = false;
};

[[noreturn]] inline void reject(const std::string& what) { umbrage::detail::fail("umbrage::wgsl::text: " + what); }

/// Name of a type in WGSL.
[[nodiscard]] inline std::string name_of(std::string_view type) {
    if (!glsl::detail::is_type(type)) glsl::detail::unknown("wgsl", type);
    return std::string(glsl::detail::find_word(type)->wgsl);
}

[[nodiscard]] inline bool is_map(std::string_view type) { return type == "UMBRAGE_MAP"; }

/// Reads a text from its beginning, and returns its expressions in WGSL.
template <class = umbrage::detail::on_use>
class expressions {
public:
    expressions(std::string_view text, const signatures& functions)
        : all_(glsl::detail::newest(glsl::detail::tokens(text, "wgsl"))), functions_(functions) {}

    std::size_t at = 0;               ///< index of the next token
    std::vector<variable> variables;  ///< variables in scope; of two with one name the last counts

    /// Next token. The last token marks the end and is never taken.
    [[nodiscard]] const token& next() const { return all_[at]; }
    const token& take() { return all_[at + 1 < all_.size() ? at++ : at]; }

    /// Sign `text` with the space before it.
    std::string expect(std::string_view text) {
        if (!(next() == text)) reject("expected " + std::string(text) + " before " + std::string(next().text));
        const token& t = take();
        return std::string(t.space) + std::string(text);
    }

    /// Expression from the next token on, without the space before it.
    value expression() {
        value condition = binary(1);
        if (!(next() == "?")) return condition;
        take();
        const value yes = expression();
        expect(":");
        const value no = expression();
        if (condition.type != "bool" || yes.type != no.type)
            reject(condition.type + " ? " + yes.type + " : " + no.type);
        return {"select(" + argument(no) + ", " + argument(yes) + ", " + condition.text + ")", yes.type, primary_level,
                false, true};
    }

    /// Expression from the next token on, with the space before it.
    value spaced_expression() {
        const std::string space(next().space);
        value v = expression();
        v.text = space + v.text;
        return v;
    }

protected:
    /// Overload with these parameters; nullptr if there is none.
    [[nodiscard]] const signature* overload(std::string_view name, std::string_view parameters) const {
        for (const signature& f : functions_)
            if (f.name == name && f.parameters == parameters) return &f;
        return nullptr;
    }

    const std::vector<token> all_;

private:
    const signatures& functions_;

    static constexpr int equality_level = 6, relation_level = 7, shift_level = 8, unary_level = 11, primary_level = 12;

    static int level_of(std::string_view sign) {
        static constexpr struct {
            std::string_view sign;
            int level;
        } levels[]{{"||", 1}, {"&&", 2}, {"|", 3},  {"^", 4},  {"&", 5}, {"==", 6}, {"!=", 6}, {"<", 7},  {">", 7},
                   {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};
        for (const auto& [text, level] : levels)
            if (text == sign) return level;
        return 0;
    }

    /// Operand in brackets where WGSL needs them. Its bitwise, shift and comparison operators take fewer operands
    /// without brackets than GLSL's do.
    static std::string operand(const value& v, int level, bool chained) {
        const bool bitwise = level >= 3 && level <= 5, comparing = level == equality_level || level == relation_level;
        const bool bracket = (bitwise && v.level < unary_level && !(chained && v.level == level)) ||
                             (level == shift_level && v.level < unary_level) || (comparing && v.level < shift_level) ||
                             (level == 1 && v.level == 2);
        return bracket ? "(" + v.text + ")" : v.text;
    }

    /// Argument in brackets where needed: f(a < b, c > d) would be a template in WGSL.
    static std::string argument(const value& v) { return v.level == relation_level ? "(" + v.text + ")" : v.text; }

    value binary(int lowest) {
        value left = unary();
        for (int level = level_of(next().text); next().kind == piece::sign && level >= lowest;
             level = level_of(next().text)) {
            const token& sign = take();
            const std::string space(next().space);
            value right = binary(level + 1);
            const bool shift = level == shift_level, logic = level <= 2;
            if (shift && right.type == "int" && !right.literal)
                right = {"u32(" + right.text + ")", "uint", primary_level};
            const bool compared = level == equality_level || level == relation_level;
            std::string type =
                compared || logic ? "bool" : glsl::detail::type_of_product(left.type, sign.text, right.type);
            const bool agree = logic ? left.type == "bool" && right.type == "bool"
                                     : !compared || (left.type == right.type && glsl::detail::width_of(left.type) == 1);
            if (type.empty() || !agree)
                reject(left.type + " " + std::string(sign.text) + " " + right.type + " in " + left.text);
            left = {operand(left, level, true) + std::string(sign.space) + std::string(sign.text) + space +
                        operand(right, level, false),
                    std::move(type), level};
        }
        return left;
    }

    value unary() {
        if (next() == "-" || next() == "!" || next() == "~" || next() == "+") {
            const token& sign = take();
            const std::string space(next().space);
            value v = unary();
            v.text = (sign == "+" ? "" : std::string(sign.text)) + space + v.text;
            v.level = unary_level;
            return v;
        }
        value v = primary();
        for (;;) {
            if (next() == ".") {
                const std::string dot = expect(".");
                const std::string_view fields = take().text;
                if (fields.size() > 4 || (fields.find_first_not_of("xyzw") != fields.npos &&
                                          fields.find_first_not_of("rgba") != fields.npos))
                    reject("no component " + std::string(fields) + " of " + v.text);
                v = {v.text + dot + std::string(fields),
                     glsl::detail::vector_of(glsl::detail::component_of(v.type), static_cast<int>(fields.size())),
                     primary_level};
            } else if (next() == "[") {
                const std::string open = expect("["), index = spaced_expression().text;
                v = {v.text + open + index + expect("]"), glsl::detail::element_of(v.type), primary_level};
            } else {
                return v;
            }
        }
    }

    value primary() {
        const token& t = take();
        const std::string text(t.text);
        if (t.kind == piece::number) return {text, glsl::detail::type_of_number(text), primary_level, true};
        if (t == "(") {
            value inner = spaced_expression();
            const std::string close = expect(")");
            if (inner.select) return inner;
            return {"(" + inner.text + close, inner.type, primary_level, inner.literal};
        }
        if (t.kind != piece::word) reject("unexpected " + text);
        if (t == "true" || t == "false") return {text, "bool", primary_level};
        if (next() == "(") return call(text);
        for (std::size_t i = variables.size(); i-- > 0;)
            if (variables[i].name == text) return {text, variables[i].type, primary_level};
        if (const glsl::detail::map_word* w = glsl::detail::find_map_word(text))
            return {text, std::string(w->type), primary_level};
        glsl::detail::unknown("wgsl", text);
    }

    value call(const std::string& function) {
        expect("(");
        std::vector<value> arguments;
        while (!(next() == ")")) {
            if (!arguments.empty()) expect(",");
            arguments.push_back(spaced_expression());
        }
        const std::string close = expect(")");
        if (glsl::detail::is_type(function)) return constructed(function, arguments, close);
        std::string given;
        for (const value& v : arguments) given += v.type + ',';
        if (const signature* f = overload(function, given))
            return {f->wgsl + listed(arguments) + close, f->gives, primary_level};
        for (const signature& f : functions_)
            if (f.name == function) reject("no overload of " + function + " takes what it is given");
        return built_in(function, arguments, close);
    }

    static std::string listed(const std::vector<value>& arguments) {
        std::string list = "(";
        for (const value& v : arguments) {
            const std::size_t space = v.text.find_first_not_of(" \n");
            const bool last = &v == &arguments.back();
            const value bare{v.text.substr(space), v.type, v.level};
            list += v.text.substr(0, space) + (last ? bare.text : argument(bare) + ",");
        }
        return list;
    }

    /// Constructor of a type, with each argument in its component type.
    static value constructed(const std::string& type, std::vector<value> arguments, const std::string& close) {
        const std::string component(glsl::detail::component_of(glsl::detail::is_matrix(type) ? "float" : type));
        const bool scalar = glsl::detail::width_of(type) == 1;
        const bool whole =
            arguments.size() == 1 && glsl::detail::width_of(arguments[0].type) == glsl::detail::width_of(type);
        for (value& v : arguments) {
            if (scalar || whole || v.literal || glsl::detail::component_of(v.type) == component) continue;
            const std::size_t space = v.text.find_first_not_of(" \n");
            v.text.insert(space, name_of(glsl::detail::vector_of(component, glsl::detail::width_of(v.type))) + "(");
            v.text += ")";
            v.level = primary_level;
        }
        return {name_of(type) + listed(arguments) + close, type, primary_level};
    }

    static value built_in(const std::string& function, std::vector<value> arguments, const std::string& close) {
        const glsl::detail::word* w = glsl::detail::find_word(function);
        if (!w || w->kind != glsl::detail::word_kind::function || arguments.empty())
            glsl::detail::unknown("wgsl", function);
        std::string type = arguments[0].type;
        for (const value& v : arguments)
            if (glsl::detail::width_of(v.type) > glsl::detail::width_of(type)) type = v.type;
        for (value& v : arguments) {  // in WGSL all arguments have one type
            if (v.type == type) continue;
            if (v.type != glsl::detail::component_of(type)) reject(function + " of " + type + " and " + v.type);
            const std::size_t space = v.text.find_first_not_of(" \n");
            v.text.insert(space, name_of(type) + "(");
            v.text += ")";
        }
        if (w->wgsl.starts_with("bitcast")) {
            if (glsl::detail::width_of(type) > 1) reject(function + " of " + type);
            type = w->wgsl == "bitcast<f32>" ? "float" : w->wgsl == "bitcast<u32>" ? "uint" : "int";
        }
        if (function == "dot" || function == "length") type = "float";
        return {std::string(w->wgsl) + listed(arguments) + close, type, primary_level};
    }
};

}  // namespace umbrage::wgsl::detail
