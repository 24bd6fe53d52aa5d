// SPDX-License-Identifier: MIT
//
// How bound snippets become one text, in any language: the hooks that a map chooses in place of the snippets' own, the
// words that it fills in, everything once and after what it needs.
//
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <umbrage/config.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/hooks.hpp>
#include <umbrage/shader/translate/layout.hpp>
#include <umbrage/simd/algorithm.hpp>
#include <umbrage/version.hpp>

namespace umbrage::glsl::detail {

/// A language's words for a kind of texture. Expressions read it at `at`, vec2 of whole numbers, or at `uv`, vec2 from
/// 0 to 1.
struct texture_words {
    literal parameters, arguments;
    literal texel{};                        ///< vec4; lines that begin with # stand for the whole statement
    literal sampled{};                      ///< vec4 at `uv`
    literal lit{};                          ///< the sampler's comparison with `receiver`: float
    literal gather_red{}, gather_green{};   ///< vec4
    literal gather_lit{};                   ///< the sampler's comparisons with `receiver`: vec4
    literal lit_filtered{};                 ///< those around `uv`, weighted by the sampler: float
    literal size{};                         ///< of the texture: vec2
    literal sampler{}, sampler_argument{};  ///< what gathers take behind the first parameter: ", sampler s"
    snippet_span needs{};                   ///< what these words call
};

/// What there is to know of a language.
struct language {
    literal prelude;  ///< what every text begins with
    texture_words (*texture)(glsl::texture kind);
    std::string (*translate)(const snippet& s);  ///< its text in the language, with the words that a map fills in
    bool preprocessor = true;                    ///< keeps what is pasted twice from clashing
    bool macros = false;                         ///< the hooks of a shader's one map are the snippets' own
    literal scaled_macro{};                      ///< for those of depths on a scale of their own
};

/// The text with each word replaced by replacement(word, in_comment).
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

[[nodiscard]] inline bool has_region(const binding& b) { return b.texture == texture::atlas || !b.origin.empty(); }
/// Whether a map is all of its texture, edges and all.
[[nodiscard]] inline bool is_whole(const binding& b) { return !has_region(b) && !b.outside_lit; }
[[nodiscard]] constexpr bool is_cube(texture kind) { return kind == texture::cube || kind == texture::cube_faces; }
[[nodiscard]] constexpr bool gathers(texture kind) { return !is_cube(kind) && kind != texture::integer; }
[[nodiscard]] inline bool compares(texture kind) { return kind == texture::shadow || kind == texture::shadow_array; }

/// The function that a map has in place of a hook's own text; other snippets as they are.
/// @throws std::invalid_argument  the map cannot have what is asked of it
template <class = umbrage::detail::on_use>
[[nodiscard]] const snippet& chosen(const snippet& s, const binding& b) {
    const bool forward = b.direction == depth_direction::forward;
    bool scaled = false;
    for (const snippet& need : b.needs) scaled = scaled || need.scaled;
    switch (s.role) {
        case hook::none:
        case hook::chosen: return s;
        case hook::cleared_depth: return forward ? hooks::forward_cleared_depth : hooks::reversed_cleared_depth;
        case hook::beyond_far:
            return scaled ? hooks::scaled_beyond_far : forward ? hooks::forward_beyond_far : hooks::reversed_beyond_far;
        case hook::before_far: return scaled ? s : forward ? hooks::forward_before_far : hooks::reversed_before_far;
        case hook::compare: return forward ? hooks::forward_compare : hooks::reversed_compare;
        case hook::texel:
        case hook::fetch_depth:
            if (compares(b.texture))
                umbrage::detail::fail("umbrage::glsl::bind: a comparison sampler compares, it gives no depths");
            if (s.role == hook::texel) return hooks::texel;
            return b.outside_lit ? hooks::bordered_depth : hooks::clamped_depth;
        case hook::lit:
            if (!compares(b.texture)) return s;
            return b.outside_lit ? hooks::bordered_lit : hooks::clamped_lit;
        case hook::lit_2x2:
            if (!b.gather) return s;
            if (b.outside_lit) return hooks::gathered_bordered;
            return has_region(b) ? hooks::gathered_region : hooks::gathered;
        case hook::gather_lit:
            if (!gathers(b.texture))
                umbrage::detail::fail("umbrage::glsl::bind: no gather from a cube or from whole numbers");
            if (compares(b.texture)) return hooks::gather_compared;
            if (b.channels > 2) umbrage::detail::fail("umbrage::glsl::bind: a gather of more than two channels");
            return b.channels == 2 ? hooks::gather_two_channels : hooks::gather_one_channel;
        case hook::lit_filtered:
            if (!compares(b.texture)) return s;
            return b.outside_lit ? hooks::bordered_lit_filtered : hooks::clamped_lit_filtered;
        case hook::lit_at: return compares(b.texture) && is_whole(b) ? hooks::sampled_lit : s;
        case hook::depth_at:
            return b.gather && gathers(b.texture) && !compares(b.texture) && is_whole(b) ? hooks::sampled_depth : s;
    }
    return s;
}

/// Whether a snippet's functions are a map's own: they are hooks, or call some.
template <class = umbrage::detail::on_use>
[[nodiscard]] bool is_of_map(const snippet& s) {
    for (const snippet* need : s.needs)
        if (is_of_map(*need)) return true;
    return s.role != hook::none;
}

/// What a text calls its map: `map`, or `table`.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string name_of_map(std::string_view text) {
    const std::string_view type = "UMBRAGE_MAP ";
    const auto at = text.find(type);
    if (at == text.npos) return "map";
    text.remove_prefix(at + type.size());
    return std::string(text.substr(0, text.find_first_of(",)")));
}

/// A snippet's text with what a map fills in.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string for_map(std::string text, const snippet& s, const bound& item, const texture_words& words) {
    const binding& map = item.map;
    const auto one_of = [](const std::string& own, std::string_view ordinary) {
        return own.empty() ? std::string(ordinary) : own;
    };
    const std::string origin = map.texture == texture::atlas ? one_of(map.origin, "origin") : map.origin;
    const std::string texture_size = one_of(map.texture_size, origin.empty() ? "size" : words.size);
    const auto replace = [&](std::string_view what, std::string_view with) {
        for (auto at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
            text.replace(at, what.size(), with);
    };
    const std::string texel = one_of(map.texel, words.texel);
    if (texel.starts_with('#')) replace("    return UMBRAGE_TEXEL;\n", "UMBRAGE_TEXEL");
    if (const auto at = text.find("UMBRAGE_ORIGIN"); at != text.npos && origin.empty()) {
        const auto begin = text.rfind('\n', at);
        text.erase(begin, text.find('\n', at) - begin);
    }
    const std::string own_map = name_of_map(text);
    replace("UMBRAGE_MAP " + own_map, "UMBRAGE_PARAMETERS");
    const auto list = [&](const std::string& own, std::string_view ordinary, std::string_view sampler) {
        std::string all = one_of(own, ordinary);
        if (own.empty() && map.gather) all.insert(umbrage::detail::lesser(all.find(','), all.size()), sampler);
        return replace_words(all,
                             [&](std::string_view word, bool) { return word == "map" ? own_map : std::string(word); });
    };

    const auto suffixed = [&](std::string_view word) {
        const auto is_it = [name = word.substr(8)](const snippet& own) { return own.name == name && is_of_map(own); };
        bool own = word.substr(8) == s.name;
        for (const snippet& need : map.needs) own = own || is_it(need);
        for (const snippet* need : s.needs) own = own || is_it(*need);
        return std::string(word) + (own ? item.suffix : std::string());
    };
    const auto of_texture = [&](std::string_view expression) {
        return replace_words(expression, [&](std::string_view word, bool) -> std::string {
            if (word.starts_with("umbrage_")) return suffixed(word);
            if (word == "at" && origin.empty()) return "texel";
            if (word != "UMBRAGE_TEXTURE_SIZE") return std::string(word);
            if (texture_size.empty()) umbrage::detail::fail("umbrage::glsl::bind: this language needs texture_size");
            return texture_size;
        });
    };
    return replace_words(text, [&](std::string_view word, bool comment) -> std::string {
        if (word.starts_with("umbrage_")) return suffixed(word);
        if (word == own_map && !comment) return list(map.arguments, words.arguments, words.sampler_argument);
        if (word == "UMBRAGE_PARAMETERS") return list(map.parameters, words.parameters, words.sampler);
        if (word == "UMBRAGE_DEPTH") return of_texture(one_of(map.depth, "value.x"));
        if (word == "UMBRAGE_ORIGIN") return origin;
        if (word == "UMBRAGE_TEXEL") return of_texture(texel);
        if (word == "UMBRAGE_LIT_TEXEL") return of_texture(words.lit);
        if (word == "UMBRAGE_UV") return of_texture("at / UMBRAGE_TEXTURE_SIZE");
        if (word == "UMBRAGE_SAMPLED") return of_texture(words.sampled);
        if (word == "UMBRAGE_LIT_FILTERED") return of_texture(words.lit_filtered);
        if (word == "UMBRAGE_GATHER_RED") return of_texture(words.gather_red);
        if (word == "UMBRAGE_GATHER_GREEN") return of_texture(words.gather_green);
        if (word == "UMBRAGE_GATHER_LIT") return of_texture(words.gather_lit);
        return std::string(word);
    });
}

/// One text in the making.
template <class = umbrage::detail::on_use>
class composition {
public:
    composition(const language& l, const std::vector<bound>& items) : language_(l), items_(items) {
        binding one;  // the shader's one map compares on a scale of its own if anything here makes such depths
        for (const bound& item : items_)
            if (item.by_macros && item.what.scaled) one.needs.push_back(item.what);
        for (bound& item : items_) {
            if (item.by_macros) item.map = one;
            for (const bound& other : items)
                if (!item.by_macros && item.suffix == other.suffix && !(item.map == other.map) &&
                    (!other.by_macros || is_of_map(other.what)))
                    umbrage::detail::fail("umbrage::glsl::text: two maps have one name:" + item.suffix);
        }
        if (language_.macros && !one.needs.empty()) text_ += language_.scaled_macro;
    }

    [[nodiscard]] std::string text() && {
        for_each([&](const snippet& s, const bound& item, const std::string& guard) {
            const bool of_map = is_of_map(s);
            const std::string body = language_.translate(s);
            if (language_.preprocessor) text_ += "\n#ifndef " + guard + "\n#define " + guard;
            text_ += of_map && !keeps_macros(item)
                         ? laid_out(for_map(body, s, item, language_.texture(item.map.texture)))
                         : body;
            if (language_.preprocessor) text_ += "#endif\n";
        });
        return std::move(text_);
    }

    /// The worst tier of what the text holds.
    [[nodiscard]] tier exactness() && {
        tier worst = tier::a;
        for_each([&](const snippet& s, const bound&, const std::string&) {
            if (worst < s.exactness) worst = s.exactness;
        });
        return worst;
    }

private:
    /// Calls use(snippet, item, guard) for each part of the text, in order. What belongs to no map comes first: hooks
    /// may call it, whatever the order of the items.
    template <class Part>
    void for_each(const Part& use) {
        for (const bool of_map : {false, true})
            for (const bound& item : items_) {
                for (const snippet& need : item.map.needs) add(need, item, of_map, use);
                for (const snippet* need : language_.texture(item.map.texture).needs) add(*need, item, of_map, use);
                add(item.what, item, of_map, use);
            }
    }

    template <class Part>
    void add(const snippet& asked, const bound& item, bool of_map, const Part& use) {
        const snippet& s = keeps_macros(item) ? asked : chosen(asked, item.map);
        for (const snippet* need : s.needs) add(*need, item, of_map, use);
        if (is_of_map(s) != of_map) return;
        std::string guard = "UMBRAGE_HAS_" + std::string(s.name) + (of_map ? item.suffix : std::string());
        for (char& c : guard) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        for (const std::string& done : done_)
            if (done == guard) return;
        use(s, item, guard);
        done_.push_back(std::move(guard));
    }

    [[nodiscard]] bool keeps_macros(const bound& item) const { return language_.macros && item.by_macros; }

    const language& language_;
    std::vector<bound> items_;
    std::string text_;
    std::vector<std::string> done_;
};

/// A line that names what follows, then it.
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string compose(const language& l, const std::vector<bound>& items) {
    std::string title = "// umbrage " + std::to_string(UMBRAGE_VERSION_MAJOR) + '.' +
                        std::to_string(UMBRAGE_VERSION_MINOR) + '.' + std::to_string(UMBRAGE_VERSION_PATCH) +
                        ", MIT License";
    std::string names = ": ";
    for (const bound& item : items) {
        const std::string name = std::string(item.what.name) + item.suffix + ", ";
        if (names.find(' ' + name) == names.npos) names += name;
    }
    names.resize(names.size() - 2);
    return title + names + '\n' + std::string(l.prelude) + composition<Use>(l, items).text();
}

}  // namespace umbrage::glsl::detail
