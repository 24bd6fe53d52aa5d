// SPDX-License-Identifier: MIT
//
// The npm package's data in JavaScript, a folder a language: its snippets, its encodings, and the hooks of maps.
// A snippet is a constant that refers to those it needs, so that a bundler keeps what a program calls and no more.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <type_traits>

#include <umbrage/shadow/depth_pass.hpp>

#include "module_filters.hpp"
#include "module_words.hpp"

namespace package {

/// True when a map fills in more than its type. Such a text must be kept unchanged until then.
inline bool has_words_of_map(std::string_view text) {
    bool other = false;
    (void)glsl::detail::replace_words(text, [&](std::string_view word, bool) {
        const bool everywhere = word == "UMBRAGE_HIGHP" || word == "UMBRAGE_PRECISE" || word == "UMBRAGE_MAP";
        other = other || (word.starts_with("UMBRAGE_") && !everywhere);
        return std::string();
    });
    return other;
}

inline std::string snippets_module(const shader_language& l) {
    std::string out = imports_of(l, false);
    for (const snippet* s : glsl::registry()) {
        out += before_filter(l, *s);
        out += "\nexport const " + std::string(s->name) + " = " + "{ language, name: " + literal(s->name) +
               ", summary: " + literal(s->summary) + ",\n    " + promise_of(*s, glsl::exactness({*s})) +
               ", lowest: " + literal(directive(s->lowest)) + ", role: " + literal(role(s->role)) +
               ", scaled: " + (s->scaled ? "true" : "false") + ",\n    needs: " + references(s->needs, "") + "," +
               filter_of(*s) + " text: " + template_literal(plain_text(l, *s)) + " };\n";
    }
    return out;
}

inline std::string languages_module() {
    std::string out;
    for (const shader_language& l : languages)
        out += "export const " + std::string(l.name) + " = {\n    name: " + literal(l.title) +
               ", preprocessor: " + (l.words->preprocessor ? "true" : "false") +
               ", may_reorder: " + literal(l.words->may_reorder) +
               ",\n    prelude: " + template_literal(std::string(l.words->prelude)) + ",\n};\n";
    return out;
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

inline std::string hooks_in_module(const shader_language& l) {
    const variants all(l);
    std::string out = all.constants() + "\nexport const hooks = {\n    language,\n    receiver_plane: " +
                      literal(l.words->receiver_plane) +
                      ", plane_reference: snippets.plane_reference,\n    bordered_plane_reference: "
                      "snippets.bordered_plane_reference, apply_receiver_plane: snippets.apply_receiver_plane,\n    "
                      "textures: {\n";
    for (const named_texture& t : textures)
        out += "        " + std::string(t.name) + ": " + words(l.words->texture(t.kind)) + ",\n";
    out += "    },\n    unfilled: {\n";
    for (const snippet* s : glsl::registry())
        if (const std::string text = l.words->translate(*s); has_words_of_map(text))
            out += "        " + std::string(s->name) + ": " + template_literal(text) + ",\n";
    return out + "    },\n    chosen: {\n" + all.names() + "    },\n};\n";
}

inline std::string encoding_of_module(const auto& encoding) {
    using target = typename std::decay_t<decltype(encoding)>::target;
    const glsl::binding map = glsl::stored_as(encoding);
    std::string cleared;
    for (const cleared_channel& c : cleared_channels(encoding))
        cleared += (cleared.empty() ? "" : ", ") + quotient(c.value, c.most);
    return "{ name: " + literal(encoding.name) +
           ", direction: " + literal(map.direction == umbrage::depth_direction::forward ? "forward" : "reversed") +
           ", depth: " + literal(map.depth) + ", channels: " + std::to_string(map.channels) + ", needs: [" +
           (map.needs.empty() ? "" : "snippets." + std::string(map.needs.front().name)) + "],\n    cleared: [" +
           cleared + "], format: " + literal(target::format) + ", depth_format: " + literal(target::depth_format);
}

/// Functions that the depth pass of an encoding calls.
template <class Encoding>
[[nodiscard]] glsl::own_text write_of() {
    using target = typename Encoding::target;
    const bool integers = Encoding::writes == umbrage::store_format::integers;
    return glsl::detail::write_text(*Encoding::writer, integers ? target::to_unorm : nullptr, target::channels, "");
}

inline std::string encodings_module(const shader_language& l) {
    std::string out = imports_of(l);
    umbrage::for_each_encoding([&](auto encoding) {
        const std::string name(encoding.name), write = "write_" + name;
        out +=
            "\nconst " + write + " = " +
            own_snippet(l, write_of<decltype(encoding)>(), "color of a depth, for a target of " + name, "snippets.") +
            ";\n";
        out += "export const " + name + " = " + encoding_of_module(encoding) + ", write: " + write;
        encoding = {.direction = umbrage::depth_direction::reversed};
        out += ",\n    reversed: " + encoding_of_module(encoding) + ", write: " + write + " } };\n";
    });
    return out;
}

}  // namespace package
