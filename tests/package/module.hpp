// SPDX-License-Identifier: MIT
//
// The npm package's data in JavaScript, a folder a language: its name, its snippets, the hooks of maps, the encodings.
// A snippet is a constant that refers to those it needs, so that a bundler keeps what a program calls and no more.
#pragma once

#include <iomanip>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "languages.hpp"

namespace package {

using glsl::snippet;

/// A text between backticks.
inline std::string template_literal(const std::string& text) {
    if (text.find_first_of("`\\$") != text.npos) throw std::runtime_error("not fit for a template literal: " + text);
    return '`' + text + '`';
}

inline std::string_view role(glsl::hook h) {
    switch (h) {
        case glsl::hook::none: return "none";
        case glsl::hook::cleared_depth: return "cleared_depth";
        case glsl::hook::map_covers: return "map_covers";
        case glsl::hook::beyond_far_plane: return "beyond_far_plane";
        case glsl::hook::within_far_plane: return "within_far_plane";
        case glsl::hook::compare: return "compare";
        case glsl::hook::texel: return "texel";
        case glsl::hook::fetch_depth: return "fetch_depth";
        case glsl::hook::lit: return "lit";
        case glsl::hook::lit_2x2: return "lit_2x2";
        case glsl::hook::gather_lit: return "gather_lit";
        case glsl::hook::lit_filtered: return "lit_filtered";
        case glsl::hook::lit_at: return "lit_at";
        case glsl::hook::depth_at: return "depth_at";
        case glsl::hook::chosen: return "chosen";
    }
    return "";
}

/// A quotient of integers as JavaScript has it. Bundlers keep what divides, as they do not know that it has no effect.
inline std::string quotient(long a, long b) {
    std::ostringstream out;
    out << std::setprecision(17) << static_cast<double>(a) / static_cast<double>(b);
    return out.str();
}

/// Snippets of a module that imports them all.
inline std::string snippets(std::span<const snippet* const> all) {
    std::string out = "[";
    for (const snippet* s : all) out += (out.size() > 1 ? ", snippets." : "snippets.") + std::string(s->name);
    return out + ']';
}

/// What is promised of a snippet.
inline std::string promise_of(const snippet& s, glsl::tier exactness) {
    return "exactness: \"" + std::string(1, "abc"[static_cast<int>(exactness)]) +
           "\", operations: " + std::to_string(s.operations) +
           ", within: " + (s.within > 0.0f ? quotient(1, static_cast<int>(1.0f / s.within)) : "0") +
           ", as_written: " + (s.as_written ? "true" : "false");
}

/// What a map fills in beside its type: a text that must be kept as it is before that.
inline bool has_words_of_map(std::string_view text) {
    bool other = false;
    (void)glsl::detail::replace_words(text, [&](std::string_view word, bool) {
        const bool everywhere = word == "UMBRAGE_HIGHP" || word == "UMBRAGE_PRECISE" || word == "UMBRAGE_MAP";
        other = other || (word.starts_with("UMBRAGE_") && !everywhere);
        return std::string();
    });
    return other;
}

/// A snippet's text for a 2D texture of depths.
inline std::string plain_text(const shader_language& l, const snippet& s) {
    const std::string text = l.words->translate(s);
    if (!glsl::detail::is_of_map(s)) return text;
    const glsl::detail::texture_words words = l.words->texture(glsl::texture::texture_2d);
    return glsl::detail::laid_out(glsl::detail::for_map(text, s, s, words));
}

inline std::string snippets_module(const shader_language& l) {
    std::string out = "import { language } from './language.mjs';\n";
    for (const snippet* s : glsl::registry()) {
        std::string needs = "[";
        for (const snippet* need : s->needs) needs += (needs.size() > 1 ? ", " : "") + std::string(need->name);
        out += "\nexport const " + std::string(s->name) + " = " + "{ language, name: " + literal(s->name) +
               ", summary: " + literal(s->summary) + ",\n    " + promise_of(*s, glsl::exactness({*s})) +
               ", lowest: " + literal(directive(s->lowest)) + ", role: " + literal(role(s->role)) +
               ", scaled: " + (s->scaled ? "true" : "false") + ",\n    needs: " + needs +
               "], text: " + template_literal(plain_text(l, *s)) + " };\n";
    }
    return out;
}

inline std::string language_module(const shader_language& l) {
    return "export const language = {\n    name: " + literal(l.title) +
           ", preprocessor: " + (l.words->preprocessor ? "true" : "false") +
           ", may_reorder: " + literal(l.words->may_reorder) +
           ",\n    prelude: " + template_literal(std::string(l.words->prelude)) + ",\n};\n";
}

inline std::string words(const glsl::detail::texture_words& w) {
    std::string out = "{ ";
    const auto add = [&](std::string_view name, std::string_view value) {
        if (!value.empty()) out += std::string(name) + ": " + literal(value) + ", ";
    };
    add("parameters", w.parameters);
    add("arguments", w.arguments);
    add("texel", w.texel);
    add("sampled", w.sampled);
    add("lit", w.lit);
    add("gather_red", w.gather_red);
    add("gather_green", w.gather_green);
    add("gather_lit", w.gather_lit);
    add("lit_filtered", w.lit_filtered);
    add("size", w.size);
    add("sampler", w.sampler);
    add("sampler_argument", w.sampler_argument);
    return out + "needs: " + snippets(w.needs) + " }";
}

/// Constants of the hooks' variants, each behind those that it needs, and their names by what they stand for.
class variants {
public:
    explicit variants(const shader_language& l) : language_(l) {
        for (const snippet* s : glsl::hooks::all) add(*s);
    }
    [[nodiscard]] const std::string& constants() const { return constants_; }
    [[nodiscard]] const std::string& names() const { return names_; }

private:
    static bool is_variant(const snippet& s) {
        for (const snippet* other : glsl::hooks::all)
            if (other == &s) return true;
        return false;
    }
    static std::string constant(const snippet& s) {
        std::string name;
        for (const char c : s.summary)
            if (c != ',') name += c == ' ' ? '_' : c;
        return name;
    }
    void add(const snippet& s) {
        const std::string name = constant(s);
        if (constants_.find("const " + name + " =") != constants_.npos) return;
        std::string needs = "[";
        for (const snippet* need : s.needs) {
            if (is_variant(*need)) add(*need);
            needs += (needs.size() > 1 ? ", " : "") +
                     (is_variant(*need) ? constant(*need) : "snippets." + std::string(need->name));
        }
        constants_ += "const " + name + " = { name: " + literal(s.name) + ", role: " + literal(role(s.role)) + ", " +
                      (s.exactness == glsl::tier::a ? "" : promise_of(s, s.exactness) + ", ") + "needs: " + needs +
                      "],\n    text: " + template_literal(language_.words->translate(s)) + " };\n";
        names_ += "        " + literal(s.summary) + ": " + name + ",\n";
    }

    const shader_language& language_;
    std::string constants_, names_;
};

inline std::string hooks_module(const shader_language& l) {
    const variants all(l);
    std::string out = "import { language } from './language.mjs';\nimport * as snippets from './snippets.mjs';\n\n" +
                      all.constants() + "\nexport const hooks = {\n    language,\n    receiver_plane: " +
                      literal(l.words->receiver_plane) +
                      ", apply_receiver_plane: snippets.apply_receiver_plane,\n    textures: {\n";
    for (const named_texture& t : textures)
        out += "        " + std::string(t.name) + ": " + words(l.words->texture(t.kind)) + ",\n";
    out += "    },\n    unfilled: {\n";
    for (const snippet* s : glsl::registry())
        if (const std::string text = l.words->translate(*s); has_words_of_map(text))
            out += "        " + std::string(s->name) + ": " + template_literal(text) + ",\n";
    return out + "    },\n    chosen: {\n" + all.names() + "    },\n};\n";
}

inline std::string encoding_of_module(const auto& encoding) {
    using type = std::decay_t<decltype(encoding)>;
    const glsl::binding map = glsl::stored_as(encoding);
    std::string cleared;
    for (const cleared_channel& c : cleared_channels(encoding))
        cleared += (cleared.empty() ? "" : ", ") + quotient(c.value, c.most);
    return "{ direction: " + literal(map.direction == umbrage::depth_direction::forward ? "forward" : "reversed") +
           ", depth: " + literal(map.depth) + ", channels: " + std::to_string(map.channels) + ", needs: [" +
           (map.needs.empty() ? "" : "snippets." + std::string(map.needs.front().name)) + "],\n    writer: snippets." +
           std::string(type::writer->name) + ", writes: " + literal(writes(encoding)) +
           ", format: " + literal(type::target::format) +
           (type::writes == umbrage::store_format::integers
                ? ", to_unorm: snippets." + std::string(type::target::to_unorm->name)
                : "") +
           ", cleared: [" + cleared + "]";
}

inline std::string encodings_module() {
    std::string out = "import * as snippets from './snippets.mjs';\n";
    umbrage::for_each_encoding([&](auto encoding) {
        out += "\nexport const " + std::string(encoding.name) + " = " + encoding_of_module(encoding);
        encoding = {.direction = umbrage::depth_direction::reversed};
        out += ",\n    reversed: " + encoding_of_module(encoding) + " } };\n";
    });
    return out;
}

}  // namespace package
