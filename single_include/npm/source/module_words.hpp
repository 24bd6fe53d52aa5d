// SPDX-License-Identifier: MIT
//
// Words of the npm package's data: literals of JavaScript, and the form of a snippet.
#pragma once

#include <algorithm>
#include <iomanip>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include <umbrage/shader/bind.hpp>

#include "languages.hpp"

namespace package {

using glsl::snippet;

/// First lines of a module of a language's data.
inline std::string imports_of(const shader_language& l, bool snippets = true) {
    return "import { " + std::string(l.name) + " as language } from '../languages.mjs';\n" +
           (snippets ? "import * as snippets from './snippets.mjs';\n" : "");
}

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
        case glsl::hook::gather_clamped: return "gather_clamped";
        case glsl::hook::gather: return "gather";
        case glsl::hook::lit_filtered: return "lit_filtered";
        case glsl::hook::covered: return "covered";
        case glsl::hook::texel_inside: return "texel_inside";
        case glsl::hook::lit_between: return "lit_between";
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

/// References to snippets, whose module is the one at work or is imported.
inline std::string references(std::span<const snippet* const> all, const std::string& from) {
    std::string out = "[";
    for (const snippet* s : all) out += (out.size() > 1 ? ", " : "") + from + std::string(s->name);
    return out + ']';
}
inline std::string snippets(std::span<const snippet* const> all) { return references(all, "snippets."); }

/// Promise of a snippet.
inline std::string promise_of(const snippet& s, glsl::tier exactness) {
    return "exactness: \"" + std::string(1, "abc"[static_cast<int>(exactness)]) +
           "\", operations: " + std::to_string(s.operations) +
           ", within: " + (s.within > 0.0f ? quotient(1, static_cast<int>(1.0f / s.within)) : "0") +
           ", as_written: " + (s.as_written ? "true" : "false");
}

/// A snippet's text for a 2D texture of depths.
inline std::string plain_text(const shader_language& l, const snippet& s) {
    const std::string text = l.words->translate(s);
    if (!glsl::detail::is_of_map(s)) return text;
    const glsl::detail::texture_words words = l.words->texture(glsl::texture::texture_2d);
    return glsl::detail::laid_out(glsl::detail::for_map(text, s, s, words));
}

/// A snippet that is made where it is used, in the snippets' module, or one that imports them.
inline std::string own_snippet(const shader_language& l, const glsl::own_text& own, std::string_view summary,
                               const std::string& from) {
    glsl::version lowest = glsl::version::v100;
    for (const snippet* need : own.needs) lowest = std::max(lowest, need->lowest);
    const snippet s{.name = own.name, .needs = own.needs, .source = own.source.c_str()};
    return "{ language, name: " + literal(s.name) + ", summary: " + literal(summary) + ",\n    " +
           promise_of(s, glsl::exactness({s})) + ", lowest: " + literal(directive(lowest)) +
           ", role: \"none\", scaled: false,\n    needs: " + references(s.needs, from) +
           ", text: " + template_literal(plain_text(l, s)) + " }";
}

}  // namespace package
