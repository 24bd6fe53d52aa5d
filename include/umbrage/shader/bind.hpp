// SPDX-License-Identifier: MIT
//
// Snippets bound to maps, so that one shader can sample several kinds of map. Each map's functions have its own suffix.
//
//     using namespace umbrage::glsl;
//     std::string shader = source(version::v330, {bind(pcf_2x2, "sun", {.texture = texture::array}),
//                                                 bind(box, "spot", stored_as(umbrage::rg<11>{}))});
//     // umbrage_pcf_2x2_sun(sampler2DArray map, float layer, vec2 size, ...), umbrage_box_spot(sampler2D map, ...)
//
// Also called: textureGather, GatherCmp, gather4 (bind).
//
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/shader/binding.hpp>
#include <umbrage/shader/hook_choice.hpp>
#include <umbrage/shader/interface.hpp>

namespace umbrage::glsl {

namespace detail {

[[nodiscard]] constexpr bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Text with each word replaced by replacement(word, in_comment).
template <class Replacement>
[[nodiscard]] std::string replace_words(std::string_view text, const Replacement& replacement) {
    std::string out;
    bool comment = false;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && is_word(text[end])) ++end;
        if (end > i) {
            out += replacement(text.substr(i, end - i), comment);
            i = end;
            continue;
        }
        comment = text[i] == '\n' ? false : comment || text.substr(i, 2) == "//";
        out += text[i++];
    }
    return out;
}

/// Words of a text, without those in comments.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> all;
    (void)replace_words(text, [&](std::string_view word, bool comment) {
        if (!comment) all.push_back(word);
        return std::string();
    });
    return all;
}

template <class = umbrage::detail::on_use>
[[nodiscard]] bool contains(const std::vector<std::string_view>& all, std::string_view word) {
    for (const std::string_view one : all)
        if (one == word) return true;
    return false;
}

/// True for a part of an identifier: letters, digits, single underscores between them.
[[nodiscard]] constexpr bool is_part_of_identifier(std::string_view name) {
    char before = '_';
    for (const char c : name) {
        if (!is_word(c) || (c == '_' && before == '_')) return false;
        before = c;
    }
    return name.empty() || before != '_';
}

/// True for a text that can stand in an expression: one line, brackets in pairs, no comment, directive or statement.
template <class = umbrage::detail::on_use>
[[nodiscard]] bool is_expression(std::string_view text) {
    std::string closing;
    bool blank = true;
    for (const char c : text) {
        if (c < ' ' || c > '~' || std::string_view(";#\\\"'`").find(c) != std::string_view::npos) return false;
        blank = blank && c == ' ';
        if (c == '(' || c == '[' || c == '{') closing += c == '(' ? ')' : c == '[' ? ']' : '}';
        if (c != ')' && c != ']' && c != '}') continue;
        if (closing.empty() || closing.back() != c) return false;
        closing.pop_back();
    }
    return closing.empty() && !blank && text.find("//") == text.npos && text.find("/*") == text.npos;
}

/// Members of a list separated by commas. Commas in brackets do not count.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::vector<std::string_view> members(std::string_view list) {
    std::vector<std::string_view> all;
    int open = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= list.size(); ++i) {
        const char c = i < list.size() ? list[i] : ',';
        if (c == '(' || c == '[' || c == '{' || c == '<') ++open;
        if (c == ')' || c == ']' || c == '}' || c == '>') --open;
        if (c != ',' || (open > 0 && i < list.size())) continue;
        all.push_back(list.substr(begin, i - begin));
        begin = i + 1;
    }
    return all;
}

/// True for one expression. A list, with commas outside brackets, is none, nor is an assignment.
template <class = umbrage::detail::on_use>
[[nodiscard]] bool is_one_expression(std::string_view text) {
    for (std::size_t i = text.find('='); i != text.npos; i = text.find('=', i + 1)) {
        const bool compares = i > 0 && std::string_view("=<>!").find(text[i - 1]) != std::string_view::npos;
        if (!compares && text.substr(i + 1, 1) != "=") return false;
    }
    return is_expression(text) && members(text).size() == 1;
}

/// Expression as an operand: in parentheses, unless it is a name, a number, a call or in brackets already.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string as_operand(const std::string& text) {
    int open = 0;
    bool simple = true;
    for (const char c : text) {
        if (c == '(' || c == '[' || c == '{') ++open;
        simple = simple && (open > 0 || is_word(c) || c == '.');
        if (c == ')' || c == ']' || c == '}') --open;
    }
    return simple ? text : "(" + text + ")";
}

/// Checks that the map supports every hook that the snippet calls.
template <class = umbrage::detail::on_use>
void check_hooks(const snippet& what, const snippet& asked, const binding& map) {
    const bool reads = asked.role == hook::texel || asked.role == hook::fetch_depth;
    umbrage::detail::require(!reads || !compares(map.texture), "glsl::bind", "what",
                             "a snippet that reads no depths, as a comparison sampler gives none", what.name);
    umbrage::detail::require(asked.role != hook::gather || gathers(map.texture), "glsl::bind", "map.gather",
                             "false where texels of cubes or whole numbers are gathered", map.gather);
    umbrage::detail::require(asked.role != hook::gather || map.channels <= 2, "glsl::bind", "map.channels",
                             "1 or 2 where texels are gathered", map.channels);
    umbrage::detail::require(&asked != &hooks::decode || !contains(words_of(map.depth), "texel"), "glsl::bind",
                             "map.depth", "of value alone where texels are gathered", map.depth);
    umbrage::detail::require(asked.role != hook::lit_filtered || !map.receiver_plane || !compares(map.texture),
                             "glsl::bind", "map.receiver_plane", "false where a sampler weights a region's comparisons",
                             map.receiver_plane);
    for (const snippet* need : chosen(asked, map).needs) check_hooks(what, *need, map);
}

/// Checks a binding for errors that would not compile in any language.
/// @throws std::invalid_argument   a name, map or snippet that do not fit together
template <class = umbrage::detail::on_use>
void check(const snippet& what, std::string_view name, const binding& map) {
    umbrage::detail::require(is_part_of_identifier(name), "glsl::bind", "name",
                             "letters, digits and single underscores between them", name);
    const bool one_channel =
        compares(map.texture) || map.texture == texture::depth || map.texture == texture::depth_array;
    umbrage::detail::require(1 <= map.channels && map.channels <= 4, "glsl::bind", "map.channels", "1 to 4",
                             map.channels);
    umbrage::detail::require(!one_channel || map.channels == 1, "glsl::bind", "map.channels", "1 for a depth texture",
                             map.channels);
    umbrage::detail::require(!compares(map.texture) || map.depth.empty(), "glsl::bind", "map.depth",
                             "empty for a comparison sampler", map.depth,
                             "It reads a depth texture: depth32f, depth24 or depth16.");
    const auto expression = [](const std::string& own, const char* argument) {
        umbrage::detail::require(own.empty() || is_one_expression(own), "glsl::bind", argument,
                                 "one expression on one line", own);
    };
    const auto expressions = [](const std::string& own, const char* argument, const char* condition) {
        umbrage::detail::require(own.empty() || is_expression(own), "glsl::bind", argument, condition, own);
    };
    umbrage::detail::require(!compares(map.texture) || map.compare.empty(), "glsl::bind", "map.compare",
                             "empty for a comparison sampler", map.compare);
    expression(map.depth, "map.depth");
    expression(map.compare, "map.compare");
    expression(map.origin, "map.origin");
    expression(map.texture_size, "map.texture_size");
    expression(map.texel, "map.texel");
    expressions(map.parameters, "map.parameters", "parameters on one line");
    expressions(map.arguments, "map.arguments", "expressions on one line");
    for (const snippet& need : map.needs)
        umbrage::detail::require(!reads_map(need), "glsl::bind", "map.needs", "snippets that read no map", need.name);
    umbrage::detail::require(!map.receiver_plane || (map.compare.empty() && !(map.gather && compares(map.texture))),
                             "glsl::bind", "map.receiver_plane",
                             "false where a sampler gathers comparisons, or with an own comparison",
                             map.receiver_plane);
    check_hooks(what, what, map);
}

}  // namespace detail

/// Text made for one binding, and the snippets it calls.
struct own_text {
    std::string name, source;
    std::vector<const snippet*> needs{};
};

namespace detail {

/// Own texts as snippets. Each may call those before it. They are valid as long as the texts and this object.
class own_snippets {
public:
    template <class = umbrage::detail::on_use>
    explicit own_snippets(const std::vector<own_text>& texts) : needs_(texts.size()) {
        all_.reserve(texts.size());  // reserved: the elements are pointed to
        for (std::size_t i = 0; i < texts.size(); ++i) {
            needs_[i] = texts[i].needs;
            for (const snippet& before : all_) needs_[i].push_back(&before);
            all_.push_back({.name = texts[i].name, .needs = needs_[i], .source = texts[i].source.c_str()});
        }
    }
    own_snippets(const own_snippets&) = delete;

    [[nodiscard]] auto begin() const { return all_.begin(); }
    [[nodiscard]] auto end() const { return all_.end(); }

private:
    std::vector<std::vector<const snippet*>> needs_;
    std::vector<snippet> all_;
};

}  // namespace detail

/// Snippet and the map that it is bound to. A snippet without a binding is bind(snippet, "", {}): a 2D depth texture.
struct bound {
    snippet what;
    std::string suffix{};
    binding map{};
    std::optional<shader_interface> declared{};  ///< for a shadow: declarations of the text,
    std::vector<own_text> texts{};               ///< and its functions. `what` then only names it

    template <class = umbrage::detail::on_use>
    bound(const snippet& s) : what(s) {}
    template <class = umbrage::detail::on_use>
    bound(const snippet& s, std::string_view name, binding b)
        : what(s), suffix(name.empty() ? "" : "_" + std::string(name)), map(std::move(b)) {
        if (!map.receiver_plane) return;
        map.needs.push_back(detail::is_bordered(map) ? bordered_plane_reference : plane_reference);
        if (!detail::compares(map.texture)) map.needs.push_back(apply_receiver_plane);
    }
};

/// Snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty.
/// @param what   snippet to bind
/// @param name   letters, digits, single underscores between them; may be empty
/// @param map    map that it reads
/// @throws std::invalid_argument   another name; a map that does not support what the snippet needs
template <class = umbrage::detail::on_use>
[[nodiscard]] bound bind(const snippet& what, std::string_view name, binding map = {}) {
    detail::check(what, name, map);
    return {what, name, std::move(map)};
}

}  // namespace umbrage::glsl
